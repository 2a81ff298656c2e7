## -*- texinfo -*-
## @deftypefn {} {[@var{exact}, @var{lacks}] =} exact_arc (@var{scene})
## The geometrically exact rod of a checked @var{scene} of one curved rod: a checked scene of that body on its hinge,
## with the same points, loads and times, whose field exact is the scene itself (see @code{exact_arc_kind}).  Where it
## has not what the scene has, @var{exact} is empty, and @var{lacks} (a text) says what.
## @end deftypefn

function [exact, lacks] = exact_arc (scene)
  exact = [];
  lacks = arc_lacks (scene);
  if (! isempty (lacks))
    return;
  endif
  given = struct ("title", scene.title, "gravity", scene.gravity, "duration", scene.duration, "zoom", scene.zoom, ...
                  "frames_per_second", scene.frames_per_second, "frame_size", scene.frame_size, ...
                  "breaks", scene.moment_breaks, "solver", scene.solver);
  if (isempty (scene.solver.step))
    given.solver = rmfield (given.solver, "step");
  endif
  initial = struct ("phi", scene.initial.phi, "phi_dot", scene.initial.phi_dot);
  model = struct ("energy", scene.model.energy, "rotary_inertia", scene.model.rotary_inertia, "stiffening", "exact");
  given.bodies = {struct("rod", scene.rod, "tip_mass", scene.tip_mass, "initial", initial, "model", model)};
  given.joints = {at_O("hinge", "revolute")};
  if (any (scene.moment (load_times (scene))))
    given.joints{end+1} = setfield (at_O ("moment", "moment"), "value", scene.moment);
  endif
  exact = check_mechanism (given);
  exact.exact = scene;
endfunction

## where a rod is thick against its radius, layers inside of its axis are shorter than those outside
function what = arc_lacks (scene)
  what = exact_lacks (scene, {"constrained"});
  initial = scene.initial;
  if (too_thick (scene.rod, rod_section (scene.rod, scene.model)))
    what = "a rod so thick that its curvature changes its section";
  elseif (any ([initial.V1(:); initial.V2(:); initial.V1_dot(:); initial.V2_dot(:)]))
    what = "a deformed start of a curved axis";
  endif
endfunction

function joint = at_O (name, kind)
  joint = struct ("name", name, "kind", kind, "bodies", 1, "stations", 0);
endfunction

%!test # an arc that hardly bends, as its modes have it, thrown with a mass at its tip, under a moment; its angle, too
%! scene = arc_pendulum ();
%! scene.rod = setfield (setfield (scene.rod, "lambda", 1.2e14), "mu", 8.1e13);
%! [scene.duration, scene.frames_per_second, scene.tip_mass] = deal (0.3, 20, 0.2);
%! [scene.initial.phi, scene.initial.phi_dot] = deal (-3, 3);
%! scene.moment = @(t) 2*t;
%! evalc ("exact = driver (scene, 'exact', true, 'tolerance', 1e-5, 'output', '');");
%! evalc ("modes = driver (scene, 'exact', false, 'modes', [2 6], 'tolerance', 1e-6, 'output', '');");
%! assert (exact.history.phi, modes.history.phi, 1e-5); assert (exact.history.phi_dot, modes.history.phi_dot, 1e-3);
%! assert (hypot (exact.history.tip_x - modes.history.tip_x, exact.history.tip_y - modes.history.tip_y) < 2e-5);
%! assert (max (abs (modes.history.q(:))) > 1e-5);
%!test # straight, a short bend, straight: it starts as it was made, without energy
%! scene = arc_pendulum ();
%! scene.rod = setfield (setfield (scene.rod, "curvature", @(xi) 5*(xi > 0.5 & xi < 0.6)), "curvature_breaks", [0.6 0.5]);
%! [scene.duration, scene.gravity] = deal (0.02, 0);
%! evalc ("result = driver (scene, 'exact', true, 'tolerance', 1e-3, 'output', '');");
%! assert (result.history.U, 0*result.history.t, 1e-12);
%! [x, y] = undeformed_places (struct ("axis", rod_axis (result.scene.exact.rod, 16)), scene.rod.length);
%! assert (hypot (result.history.tip_x(1), result.history.tip_y(1)), hypot (x, y), 1e-12);
%!test # what it has not
%! lacks = @(varargin) nthargout (2, @exact_arc, check_scene (setfield (arc_pendulum (), varargin{:})));
%! assert (lacks ("gravity", 9), "");
%! assert (lacks ("initial", "V2", 1e-3), "a deformed start of a curved axis");
%! assert (lacks ("rod", "half_height", 0.05), "a rod so thick that its curvature changes its section");
%!test # its solver's step
%! assert (exact_arc (check_scene (setfield (arc_pendulum (), "solver", "step", 1e-3))).solver.step, 1e-3);
