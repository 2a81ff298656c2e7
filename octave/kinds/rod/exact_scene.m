## -*- texinfo -*-
## @deftypefn {} {[@var{plane}, @var{lacks}] =} exact_scene (@var{scene})
## The geometrically exact rod of a checked scene of one straight rod: a checked scene of a rod on the upright plane
## (see @code{exact_kind}) with the same points, loads and times, whose field exact has phi at first (rad).  Where it
## has not what the scene has, @var{plane} is empty, and @var{lacks} (a text) says what.
## @end deftypefn

function [plane, lacks] = exact_scene (scene)
  plane = [];
  lacks = exact_lacks (scene, {"rate", "residual"});
  if (! isempty (lacks))
    return;
  endif
  section = rod_section (scene.rod, scene.model);
  plane = struct ("title", scene.title, "gravity", scene.gravity, "moment", scene.moment, ...
                  "tip_mass", scene.tip_mass, "breaks", scene.breaks, "duration", scene.duration, ...
                  "frames_per_second", scene.frames_per_second, "frame_size", scene.frame_size, ...
                  "ends", {{"hinge", "free"}});
  plane.exact = scene.initial.phi;
  plane.model.strain = "engineering";
  plane.surface = struct ("name", "plane", "inclination", pi/2, "side", 0);
  plane.view = struct ("elevation", 0, "azimuth", -90);
  plane.rod = struct ("length", scene.rod.length, "EA", section.EA, "EI", section.EI, "rhoA", section.rhoA, ...
                      "rhoI", section.rhoI, "damping", scene.rod.damping);
  [plane.initial.shape, plane.initial.velocity] = deformed_start (scene);
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
  plane = exact_kind ().check (plane);
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
%!  plane = exact_scene (scene);
%!  plane.solver.tolerance /= 2;
%!  exact = run_model (exact_kind (), plane, exact_kind ().sized (plane, 8));
%!  off = [distance(exact, run), max(abs (run.history.q(:)))];
%!endfunction
%!test # a rod that hardly bends moves as its modes have it: on a hinge, under all loads
%! off = against_modes ("moment", @(t) 0.3*(t < 0.1), "initial", struct ("phi", -0.4, "phi_dot", 2));
%! assert (off(1) < 3e-6); assert (off(2) > 5e-5);
%!test # and in a hub
%! off = against_modes ("rotation", @(t) [3*t + 4*t^2, 3 + 8*t, 8]);
%! assert (off(1) < 3e-6); assert (off(2) > 5e-5);
%!test # its solver, with and without a step
%! solver = @(varargin) exact_scene (check_scene (setfield (swing (), "solver", struct (varargin{:})))).solver;
%! rk4 = solver ("name", "rk4", "tolerance", 1e-7);
%! assert ({rk4.name, rk4.step, rk4.rho_infinity, rk4.tolerance}, {"rk4", [], 0.8, 1e-7});
%! assert (solver ("name", "generalized_alpha", "step", 1e-3, "rho_infinity", 0.5).step, 1e-3);
