## -*- texinfo -*-
## @deftypefn {} {[@var{plane}, @var{lacks}] =} exact_scene (@var{scene})
## The geometrically exact rod of a checked scene of one rod: a scene of a rod on the upright plane (see
## @code{exact_kind}), with the same points, loads and times; its field exact has phi
## at first and the undeformed tangent's angle at O in the frame of the rod's models (rad).  Where it has not what the scene has, @var{plane} is empty, and
## @var{lacks} (a text) says what.
## @end deftypefn

function [plane, lacks] = exact_scene (scene)
  plane = [];
  lacks = exact_lacks (scene);
  if (! isempty (lacks))
    return;
  endif
  section = rod_section (scene.rod, scene.model);
  plane = struct ("title", scene.title, "gravity", scene.gravity, "moment", scene.moment, "tip_mass", scene.tip_mass, ...
                  "moment_breaks", scene.moment_breaks, "duration", scene.duration, ...
                  "frames_per_second", scene.frames_per_second, "frame_size", scene.frame_size, ...
                  "ends", {{"hinge", "free"}});
  plane.exact = [scene.initial.phi, 0];
  plane.model.strain = "engineering";
  plane.surface = struct ("name", "plane", "inclination", pi/2, "side", 0);
  plane.view = struct ("elevation", 0, "azimuth", -90);
  plane.rod = struct ("length", scene.rod.length, "EA", section.EA, "EI", section.EI, "rhoA", section.rhoA, ...
                      "rhoI", section.rhoI, "damping", scene.rod.damping, "curvature", scene.rod.curvature, ...
                      "curvature_breaks", scene.rod.curvature_breaks);
  if (isempty (scene.rod.curvature))
    [plane.initial.shape, plane.initial.velocity] = deformed_start (scene);
  else
    plane = curved (plane, scene, section);
  endif
  if (! isempty (scene.rotation))
    plane.rotation = scene.rotation;
    plane.ends = {"clamped", "free"};
  endif
  if (! isempty (scene.force))
    plane.force = @(t) upright (scene.force (t));
    plane.force_station = scene.force_station;
  endif
  plane.joints = arrayfun (@on_plane, scene.joints(:).', "uniformoutput", false);
  plane.solver = rmfield (scene.solver, "step");
  if (! isempty (scene.solver.step))
    plane.solver.step = scene.solver.step;
  endif
endfunction

## as it was made, from O on, where the frame through its centre of mass has it
function plane = curved (plane, scene, section)
  base.axis = rod_axis (scene.rod, 16, section, scene.tip_mass);
  [~, ~, plane.exact(2)] = undeformed_places (base, 0);
  plane.initial.shape = @(xi) turned (base, xi, scene.initial.phi);
  plane.initial.velocity = @(xi, places) scene.initial.phi_dot*[-places(2,:); places(1,:)];
endfunction

function places = turned (base, xi, phi)
  [x, y] = undeformed_places (base, xi);
  places = [cos(phi), -sin(phi); sin(phi), cos(phi)]*[x; y];
endfunction

function joint = on_plane (joint)
  joint = struct ("name", joint.name, "kind", joint.kind, "stations", joint.stations(1), "value", joint.value, ...
                  "point", upright (joint.point), "stiffness", joint.stiffness, "damping", joint.damping, ...
                  "rest", joint.rest);
  if (strcmp (joint.kind, "force"))
    value = joint.value;
    joint.value = @(t) upright (value (t));
  endif
endfunction

function vector = upright (vector)
  vector = [vector(1), 0, vector(2)];
endfunction

%!function off = against_modes (varargin)   # of a stiff rod with everything that both have
%!  scene = struct ("duration", 0.2, "frames_per_second", 50, "tip_mass", 0.1, "force", @(t) [1, -2]*sin (9*t), ...
%!                  "force_station", 0.3, varargin{:});
%!  scene.rod = struct ("length", 0.5, "EA", 1e6, "EI", 80, "rhoA", 0.5, "damping", 1e-4);
%!  scene.model.energy = "uniaxial";
%!  scene.joints = {struct("kind", "spring", "stations", 0.4, "point", [0.2 0.3], "stiffness", 30, "damping", 0.4, ...
%!                         "rest", 0.1)
%!                  struct("kind", "moment", "stations", 0.5, "value", @(t) 0.2*t)
%!                  struct("kind", "force", "stations", 0.25, "value", [0 0.5])};
%!  scene.solver.tolerance = 1e-6;
%!  scene = check_scene (scene);
%!  rung = struct ("sines", [], "bending", 10, "longitudinal", 4, "axial", "dynamic", "stiffening", "foreshortening");
%!  run = run_model (rod_kind (), scene, build_model (scene, rung));
%!  off = [distance(exact_rod (scene, 8), run), max(abs (run.history.q(:)))];
%!endfunction
%!test # a rod that hardly bends moves as its modes have it: on a hinge, under all loads
%! off = against_modes ("moment", @(t) 0.3*(t < 0.1), "initial", struct ("phi", -0.4, "phi_dot", 2));
%! assert (off(1) < 3e-6); assert (off(2) > 5e-5);
%!test # and in a hub
%! off = against_modes ("rotation", @(t) [3*t + 4*t^2, 3 + 8*t, 8]);
%! assert (off(1) < 3e-6); assert (off(2) > 5e-5);
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
%! system = surface_rod (setfield (exact_kind ().check (exact_scene (check_scene (scene))), "model", "modes", [6 6]));
%! start = zeros (system.n, 1);
%! assert (system.energies (0, start, start)(2) < 1e-12);
%!test # its solver, with and without a step
%! solver = @(varargin) exact_scene (check_scene (setfield (swing (), "solver", struct (varargin{:})))).solver;
%! assert (solver ("name", "rk4", "tolerance", 1e-7), struct ("name", "rk4", "rho_infinity", 0.8, "tolerance", 1e-7));
%! assert (solver ("name", "generalized_alpha", "step", 1e-3, "rho_infinity", 0.5).step, 1e-3);
