## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} surface_ladder (@var{scene})
## The ladder of models (see @code{choose}) of the rod of a checked scene on its surface: a rung is [N N], polynomials
## of each of the chart's coordinates, from 4 to 32.  The first reference has 13: few polynomials lock, they cannot
## bend the rod without stretching it, which is as wrong as it is slow.  A rung holds within 0.8 of the tolerance: the
## trials' steps have a part of the rest.
## @end deftypefn

function ladder = surface_ladder (scene)
  ladder.share = 0.8;
  ladder.parts = {"polynomials"};
  ladder.first = @() deal ([8 8], "");
  ladder.richer = @(rung) min (ceil (1.5*rung) + 1, 32);
  ladder.smaller = @(rung, part) max (rung - 1, 4);
  ladder.left_out = @(reference, rung, part) left_out_of (reference, rung);
  ladder.poorer = @clearly_fewer;
  ladder.label = @(rung) sprintf ("%d", rung(1));
  ladder.labels = "polynomials of each of the chart's coordinates";
  ladder.curve = @(rung) "rungs";
  ladder.solver = setfield (scene.solver, "name", "auto");
  ladder.name = @(rung) sprintf ("%d + %d polynomials", rung);
endfunction

## Ten times what the centreline without its last polynomials is off by: it is 1 to 70 times on the shipped scenes,
## fewer polynomials lock.
function metres = left_out_of (reference, rung)
  model = reference.model.numbers;
  stations = linspace (0, sum (reference.model.weights), rows (reference.history.x)).';
  number = [0:model.modes(1)-1, 0:model.modes(2)-1].';
  q = reference.history.q;
  all_of = placed (reference.model, stations, q);
  metres = 10*distance (placed (reference.model, stations, q.*(number < rung(1))), all_of);
endfunction

## in its own chart, be it one that turns
function points = placed (system, stations, q)
  first = system.numbers.modes(1);
  length = sum (system.weights);
  place.alpha1 = rod_functions (system.numbers, 1, stations, length)*q(1:first,:);
  place.alpha2 = rod_functions (system.numbers, 2, stations, length)*q(first+1:end,:);
  [points.x, points.y, points.z] = system.surface.position (place);
endfunction

%!test # the fewest: with fewer the centreline is off by more than the tolerance
%! scene = setfield (setfield (large_swing (), "duration", 0.2), "solver", "tolerance", 1e-4);
%! scene = check_surface_scene (scene);
%! choice = choose (ladder_of (surface_kind (), scene), 1e-4);
%! assert (choice.error_m <= 1e-4); assert (choice.warnings, {});
%! trial = @(rung) ladder_of (surface_kind (), scene).trial (rung, []);
%! rich = trial ([20 20]);
%! true_error = distance (choice.trial, rich);
%! assert (true_error <= 1e-4); assert (choice.error_m/true_error, 1, 0.5);
%! assert (distance (trial (choice.rung - 1), rich) > 0.9e-4);
%! assert (min (vertcat (choice.tried.rung)(:)) > 4);
%!test # what polynomials leave out of a straight rod on the plane: nothing; of a quarter circle: less with more
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 0.01, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1));
%! ladder = ladder_of (surface_kind (), check_surface_scene (scene));
%! assert (ladder.left_out (ladder.trial ([6 6], []), [4 4], "polynomials"), 0, 1e-12);
%! scene.initial.shape = @(xi) [2/pi*sin(pi/4*xi); 2/pi*(1 - cos (pi/4*xi))];
%! ladder = ladder_of (surface_kind (), check_surface_scene (scene));
%! run = ladder.trial ([8 8], []);
%! assert (ladder.left_out (run, [4 4], "polynomials") > 10*ladder.left_out (run, [5 5], "polynomials"));
