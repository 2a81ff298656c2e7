## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} mechanism_ladder (@var{scene})
## The ladder of models (see @code{choose}) of a checked scene of several bodies.  A rung is a struct of the numbers of
## bending and of longitudinal modes of each body (1-by-bodies, see @code{mechanism_rungs}): of those with model.modes
## = "auto", from what their initial state needs to 40 + 30; 0 for the others, which keep what they state.  A part is
## one kind of modes of one body.
##
## Modes of geometrically exact bodies are polynomials, five across and one along at first; what is left out of them
## moves the rest, too: three times as far in all.
##
## A rung holds within half the tolerance: sines converge slowly where a joint acts inside a rod, so that the reference
## is not much better.
## @end deftypefn

function ladder = mechanism_ladder (scene)
  exact = arrayfun (@(body) strcmp (body.model.stiffening, "exact"), scene.bodies(:).');
  [least, most] = limits_of (scene);
  within = @(rung) between (rung, least, most);
  open = arrayfun (@(body) ischar (body.model.modes), scene.bodies);
  ladder.share = 0.5;
  ladder.parts = parts_of (most);
  first = struct ("bending", 1 + 4*exact, "longitudinal", exact);
  ladder.first = @() deal (within (first), stiffening_note_of_bodies (scene));
  ladder.richer = @(rung) within (struct ("bending", ceil (1.5*rung.bending) + 2, ...
                                          "longitudinal", 2*rung.longitudinal + 1));
  ladder.smaller = @(rung, part) within (one_less (rung, part));
  ladder.left_out = @(reference, rung, part) (1 + 2*exact(part.body))*left_out_of_body (reference, rung, part, open);
  ladder.poorer = @(rung, reference) clearly_fewer ([rung.bending, rung.longitudinal], ...
                                                    [reference.bending, reference.longitudinal]);
  ladder.label = @label_of;
  ladder.labels = "bending modes of a body, the most; +n: n longitudinal ones";
  ladder.curve = @(rung) "rungs";
  ladder.solver = setfield (scene.solver, "name", "auto");
  ladder.name = @name_of;
endfunction

function [least, most] = limits_of (scene)
  least = most = struct ("bending", zeros (1, numel (scene.bodies)), "longitudinal", zeros (1, numel (scene.bodies)));
  for k = 1:numel (scene.bodies)
    model = scene.bodies(k).model;
    initial = scene.bodies(k).initial;
    if (ischar (model.modes))
      least.bending(k) = max (numel (initial.V2), numel (initial.V2_dot));
      least.longitudinal(k) = max (numel (initial.V1), numel (initial.V1_dot));
      most.bending(k) = max (40, least.bending(k));
      if (! strcmp (model.axial, "none"))
        most.longitudinal(k) = max (30, least.longitudinal(k));
      endif
    endif
  endfor
endfunction

function rung = between (rung, least, most)
  for kind = {"bending", "longitudinal"}
    rung.(kind{1}) = max (min (rung.(kind{1}), most.(kind{1})), least.(kind{1}));
  endfor
endfunction

## longitudinal modes first, they are the fastest
function parts = parts_of (most)
  parts = {};
  for kind = {"longitudinal", "bending"}
    for k = find (most.(kind{1}) > 0)
      parts{end+1} = struct ("kind", kind{1}, "body", k);
    endfor
  endfor
endfunction

function rung = one_less (rung, part)
  rung.(part.kind)(part.body)--;
endfunction

function name = name_of (rung)
  name = ["bending modes " numbers_text(rung.bending)];
  if (any (rung.longitudinal))
    name = [name ", longitudinal " numbers_text(rung.longitudinal)];
  endif
endfunction

## the most of each kind that a body has
function label = label_of (rung)
  label = sprintf ("%d", max (rung.bending));
  if (any (rung.longitudinal))
    label = sprintf ("%s+%d", label, max (rung.longitudinal));
  endif
endfunction

function text = numbers_text (numbers)
  text = strtrim (sprintf ("%d ", numbers));
  if (numel (text) > 20)
    text = sprintf ("%d to %d", min (numbers), max (numbers));
  endif
endfunction

%!function scene = straight_rod (rod, joints)
%!  scene.bodies = {struct("rod", rod, "model", struct ("modes", "auto", "energy", "uniaxial"))};
%!  scene.joints = joints;
%!  [scene.gravity, scene.duration, scene.frames_per_second] = deal (0, 0.01, 500);
%!endfunction
%!test # a rod pulled by 10 N: where bending is still it is stretched, by up to twice F l/EA = 1 mm, which is seen
%! scene = straight_rod (struct ("length", 1, "EA", 1e4, "EI", 1e3, "rhoA", 1e-2), ...
%!   {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!    struct("kind", "force", "bodies", 1, "stations", 1, "value", [10 0])});
%! scene.solver.tolerance = 1.5e-4;
%! choice = choose (ladder_of (mechanism_kind (), check_mechanism (scene)), scene.solver.tolerance);
%! assert (choice.rung.longitudinal > 0); assert (choice.rung.bending, 0);
%! assert (choice.error_m < 1.5e-4); assert (choice.warnings, {});
%! c = 1e3; t = choice.trial.history.t;  # the triangular wave of the suddenly pulled bar, period 4 l/c
%! stretched = 1e-3*(1 - abs (mod (t*c, 4) - 2)/2)*2;
%! assert (choice.trial.history.bodies.tip_x - 1, stretched, 1.5e-4);
%!test # clamped at both ends it moves only where it bends and stretches: no run without, and no word of it
%! scene = straight_rod (struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1), ...
%!   {struct("kind", "weld", "bodies", 1, "stations", 0), ...
%!    struct("kind", "weld", "bodies", 1, "stations", 1, "point", [1 0]), ...
%!    struct("kind", "force", "bodies", 1, "stations", 0.5, "value", [0 -0.01])});
%! scene.duration = 0.14; scene.frames_per_second = 50; scene.solver.tolerance = 2e-6;
%! choice = choose (ladder_of (mechanism_kind (), check_mechanism (scene)), scene.solver.tolerance);
%! assert (choice.rung.longitudinal, 1); assert (choice.rung.bending > 0);
%! assert (choice.warnings, {}); assert (choice.trial.warnings, {});
%! assert ({choice.tried.message}, repmat ({""}, 1, numel (choice.tried)));
%! middle = min (choice.trial.y(6,:));  # down to twice F l^3/(192 EI) after half a period of 0.2808 s
%! assert (middle, -2*0.01/192, 4e-6);
%!test # an initial state of the second mode: never fewer modes than that
%! scene = straight_rod (struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1), ...
%!   {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!    struct("kind", "slider", "bodies", 1, "stations", 1, "point", [1 0])});
%! scene.bodies{1}.model.rotary_inertia = false;
%! scene.bodies{1}.initial.V2 = [0 1e-3];
%! scene.duration = 0.02; scene.solver.tolerance = 1e-6;
%! choice = choose (ladder_of (mechanism_kind (), check_mechanism (scene)), scene.solver.tolerance);
%! assert (choice.rung.bending, 2);
%! assert (choice.trial.history.bodies.V(2,:), 1e-3*cos (4*pi^2*choice.trial.history.t), 1e-6);
%!test # a soft rod needs modes, a stiff one none
%! rod = struct ("length", 0.5, "EA", 1e6, "EI", 5, "rhoA", 1);
%! model = struct ("modes", "auto", "energy", "uniaxial");
%! scene.bodies = {struct("rod", setfield (rod, "EI", 1e6), "model", model), struct("rod", rod, "model", model)};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])};
%! scene.duration = 0.2; scene.solver.tolerance = 1e-4;
%! choice = choose (ladder_of (mechanism_kind (), check_mechanism (scene)), scene.solver.tolerance);
%! assert (choice.rung.bending, [0 1]); assert (choice.rung.longitudinal, [0 0]);
%! assert (choice.error_m < 0.5e-4); assert (choice.warnings, {});
%! ladder = mechanism_ladder (check_mechanism (scene));
%! assert (ladder.label (struct ("bending", [1 3], "longitudinal", [2 0])), "3+2");
%! assert (ladder.curve ([]), "rungs");
%! assert (ladder.label (struct ("bending", [1 3], "longitudinal", [0 0])), "3");
%! richer = ladder.richer (struct ("bending", [1 3], "longitudinal", [0 2]));
%! assert (richer.longitudinal, [1 5]);
