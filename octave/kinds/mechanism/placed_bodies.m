## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{v}] =} placed_bodies (@var{scene}, @var{mechanism})
## Coordinates and rates (n-by-1) that the scene's bodies state: a body without initial.x and initial.y is where its
## first joint with a body that has its place, or with the ground, puts its point, and one without initial.x_dot and
## initial.y_dot moves as that point does.
## @end deftypefn

function [q, v] = placed_bodies (scene, mechanism)
  count = numel (scene.bodies);
  place = velocity = NaN (count, 2);
  for k = 1:count
    initial = scene.bodies(k).initial;
    place(k,:) = stated_pair (initial.x, initial.y);
    velocity(k,:) = stated_pair (initial.x_dot, initial.y_dot);
    if (! isnan (place(k,1)) && isnan (velocity(k,1)))
      velocity(k,:) = 0;
    endif
  endfor
  [place, velocity] = placed_by_joints (scene, mechanism, place, velocity);
  q = v = zeros (mechanism.n, 1);
  for k = 1:count
    initial = scene.bodies(k).initial;
    index = index_of (mechanism, k);
    V = amplitudes (initial, mechanism.models{k}.base, scene.bodies(k).name);
    q(index) = [V(:,1); initial.phi; place(k,:).'];
    v(index) = [V(:,2); initial.phi_dot; velocity(k,:).'];
  endfor
endfunction

## a number that is not stated is 0, and NaN where neither is
function pair = stated_pair (x, y)
  pair = [NaN, NaN];
  if (! isempty (x) || ! isempty (y))
    pair = [0, 0];
    pair([! isempty(x), ! isempty(y)]) = [x, y];
  endif
endfunction

## with their rates in a second column
function V = amplitudes (initial, base, name)
  V = [padded(initial, "V1", base.longitudinal, name), padded(initial, "V1_dot", base.longitudinal, name)
       padded(initial, "V2", base.transversal, name), padded(initial, "V2_dot", base.transversal, name)];
endfunction

function column = padded (initial, field, numbers, name)
  given = initial.(field)(:);
  modes = sum (numbers > 0);
  if (numel (given) > modes)
    scene_error ("%s: initial.%s has %d amplitudes for %d modes", name, field, numel (given), modes);
  endif
  column = [given; zeros(numel (numbers) - numel (given), 1)];
endfunction

%!test # the second rod hangs where the first one ends
%! [system, ~, scene] = sample_mechanism ([0 1]);
%! scene.bodies(1).initial.phi = pi/2;
%! q = placed_bodies (scene, system.mechanism);
%! assert (q(index_of (system.mechanism, 2)(end-1:end)), [0; 0.5], 1e-15);
%!test # what flies free, or hangs on a bushing, keeps the velocity that is stated, wherever its place comes from
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0]), "initial", struct ("y_dot", 0.1))};
%! scene.gravity = 0;
%! scene.duration = 0.1;
%! scene.joints = {struct("kind", "moment", "bodies", 1, "stations", 0)};
%! assert (driver (scene, "output", "").history.bodies.y(end), 0.01, 1e-9);
%! scene.joints = {struct("kind", "bushing", "bodies", 1, "stations", 0.5, "point", [2 0], "stiffness", 4)};
%! scene = check_mechanism (scene);
%! [q, v] = placed_bodies (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! assert (q, [0; 1.5; 0], 1e-15); assert (v, [0; 0; 0.1]);
%!error <body 1: initial.V2 has 2 amplitudes for 1 modes>
%! [system, ~, scene] = sample_mechanism ([0 1]); scene.bodies(1).initial.V2 = [1 2];
%! placed_bodies (scene, system.mechanism);
%!test # a rod at the tip of one that moves, with a place of its own, keeps the velocity stated, or moves as the tip does
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! still = struct ("modes", [0 0]);
%! scene.bodies = {struct("rod", rod, "model", still, "initial", struct ("phi_dot", 2)), ...
%!                 struct("rod", rod, "model", still, "initial", struct ("x", 1, "y", 0, "x_dot", 7)), ...
%!                 struct("rod", rod, "model", still)};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [1 0]), ...
%!                 struct("kind", "revolute", "bodies", [1 3], "stations", [1 0])};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! [q, v] = placed_bodies (scene, build_mechanism (scene, mechanism_rungs (scene, [0 0 0])));
%! assert (q, [0; 0; 0; 0; 1; 0; 0; 1; 0]); assert (v, [2; 0; 0; 0; 7; 0; 0; 0; 2]);
