## -*- texinfo -*-
## @deftypefn {} {[@var{exact}, @var{lacks}] =} exact_body (@var{scene})
## The geometrically exact rod of a checked @var{scene} of one rod, curved or straight: a checked scene of that body on
## its hinge, or in its hub, with the same points, loads, joints and times, whose field exact is the scene itself
## (see @code{exact_body_kind}).  Where it has not what the scene has, @var{exact} is empty, and @var{lacks} (a text)
## says what.
## @end deftypefn

function [exact, lacks] = exact_body (scene)
  exact = [];
  lacks = body_lacks (scene);
  if (! isempty (lacks))
    return;
  endif
  given = struct ("title", scene.title, "gravity", scene.gravity, "duration", scene.duration, "zoom", scene.zoom, ...
                  "frames_per_second", scene.frames_per_second, "frame_size", scene.frame_size, ...
                  "breaks", scene.breaks, "solver", scene.solver, "rod", scene.rod, "tip_mass", scene.tip_mass, ...
                  "force", scene.force, "force_station", scene.force_station);
  if (isempty (scene.solver.step))
    given.solver = rmfield (given.solver, "step");
  endif
  given.initial = struct ("phi", scene.initial.phi, "phi_dot", scene.initial.phi_dot);
  given.model = struct ("energy", scene.model.energy, "rotary_inertia", scene.model.rotary_inertia, ...
                        "stiffening", "exact");
  if (! isempty (scene.rotation))
    [given.rotation, given.initial] = deal (scene.rotation, struct ());
  endif
  if (any (scene.moment (load_times (scene))))
    given.moment = scene.moment;
  endif
  given.joints = arrayfun (@as_given, scene.joints(:).', "uniformoutput", false);
  exact = check_mechanism (as_bodies (given));
  exact.exact = scene;
endfunction

## a checked joint's second end is on the ground
function joint = as_given (joint)
  joint = rmfield (joint, {"constant", "value_name", "bodies"});
  joint.stations = joint.stations(1);
endfunction

## where a rod is thick against its radius, layers inside of its axis are shorter than those outside
function what = body_lacks (scene)
  what = exact_lacks (scene, {"constrained"});
  initial = scene.initial;
  if (too_thick (scene.rod, rod_section (scene.rod, scene.model)))
    what = "a rod so thick that its curvature changes its section";
  elseif (any ([initial.V1(:); initial.V2(:); initial.V1_dot(:); initial.V2_dot(:)]))
    what = "a deformed start beside a curved axis, or joints but springs, forces and moments";
  endif
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
%! lacks = @(varargin) nthargout (2, @exact_body, check_scene (setfield (arc_pendulum (), varargin{:})));
%! assert (lacks ("gravity", 9), "");
%! assert (lacks ("initial", "V2", 1e-3), "a deformed start beside a curved axis, or joints but springs, forces and moments");
%! assert (lacks ("rod", "half_height", 0.05), "a rod so thick that its curvature changes its section");
%!test # its solver's step
%! assert (exact_body (check_scene (setfield (arc_pendulum (), "solver", "step", 1e-3))).solver.step, 1e-3);
%!function off = against_modes (varargin)   # of a stiff rod with a spring at its hinge, and other forces
%!  scene.rod = struct ("length", 0.5, "EA", 1e6, "EI", 80, "rhoA", 0.5, "damping", 1e-4);
%!  scene.model.energy = "uniaxial";
%!  joint = @(kind, station, varargin) struct ("kind", kind, "stations", station, varargin{:});
%!  scene.joints = {joint("torsion_spring", 0, "stiffness", 3, "damping", 0.01, "rest", 0.2), ...
%!                  joint("bushing", 0.4, "point", [0.4 -0.1], "stiffness", 20), joint("force", 0.25, "value", [0 0.5])};
%!  scene.force = @(t) [1 -2]*sin (9*t);
%!  [scene.force_station, scene.tip_mass, scene.initial.phi] = deal (0.3, 0.1, -0.4);
%!  [scene.duration, scene.frames_per_second] = deal (0.2, 50);
%!  for exact = [true false]
%!    evalc ("run{2-exact} = driver (scene, 'exact', exact, 'tolerance', 1e-6, 'output', '');");
%!  endfor
%!  off = [distance(run{:}), max(abs (run{2}.history.q(:)))];
%!  assert (run{1}.history.phi, run{2}.history.phi, 2e-5);
%!  assert (run{1}.history.phi_dot, run{2}.history.phi_dot, 5e-3);
%!endfunction
%!test # a straight rod that hardly bends moves as its modes have it
%! off = against_modes ();
%! assert (off(1) < 5e-6); assert (off(2) > 5e-5);
%!test # a slender one in a hub, whose torque turns it
%! scene.rod = struct ("length", 1, "EA", 1e8, "EI", 2, "rhoA", 0.5);
%! scene.rotation = @(t) [t^3, 3*t^2, 6*t];
%! [scene.duration, scene.frames_per_second, scene.gravity] = deal (0.2, 50, 0);
%! for exact = [true false]
%!   evalc ("run{2-exact} = driver (scene, 'exact', exact, 'tolerance', 1e-7, 'output', '');");
%! endfor
%! assert (kind_of (run{1}.scene).name, "exact body");
%! assert (run{1}.history.phi, run{1}.history.t.^3, 1e-12); assert (run{1}.history.phi_dot(end), 0.12, 1e-12);
%! assert (run{1}.history.psi, run{2}.history.psi, 1e-5);
%! assert (distance (run{:}), 0, 1e-6); assert (max (abs (run{2}.history.q(:))) > 1e-3);
%! assert (run{1}.history.torque, run{2}.history.torque, 0.01*max (abs (run{2}.history.torque)));
