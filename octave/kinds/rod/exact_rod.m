## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} exact_rod (@var{scene}, @var{modes}, @var{seconds})
## The top rung of the ladder of models: the geometrically exact rod, on the upright plane (see @code{surface_rod}), of
## a checked scene of the hinged rod, in [@var{modes} @var{modes}] polynomials.  A struct of x and y (21-by-m, m), the
## centreline at the frame times, and count.  Empty for a scene with what it has not: a hub, a force, joints, a tip
## mass, damping, an initial deformation.  What takes more than so many @var{seconds} (default: any) is given up: an
## error.
## @end deftypefn

function trial = exact_rod (scene, modes, seconds = Inf)
  trial = [];
  initial = rmfield (scene.initial, {"phi", "phi_dot"});
  deformed = any (cellfun (@(V) any (V), struct2cell (initial)));
  loaded = ! isempty (scene.rotation) || ! isempty (scene.force) || ! isempty (scene.joints);
  if (loaded || scene.tip_mass > 0 || scene.rod.damping > 0 || deformed)
    return;
  endif
  section = rod_section (scene.rod, scene.model);
  plane = struct ("surface", struct ("name", "plane", "inclination", pi/2, "side", 0), "ends", {{"hinge", "free"}}, ...
                  "gravity", scene.gravity, "moment", scene.moment, "moment_breaks", scene.moment_breaks, ...
                  "duration", scene.duration, "frames_per_second", scene.frames_per_second);
  plane.rod = struct ("length", scene.rod.length, "EA", section.EA, "EI", section.EI, "rhoA", section.rhoA, ...
                     "rhoI", section.rhoI);
  plane.initial.angle = scene.initial.phi;
  plane.initial.velocity = @(xi, alpha) scene.initial.phi_dot*[-alpha(2,:); alpha(1,:)];
  plane.model.modes = [modes modes];
  plane = check_surface_scene (plane);
  system = surface_rod (plane);
  solver = struct ("name", "auto", "tolerance", scene.solver.tolerance/2, "balance", 1e-6, "seconds", seconds);
  [states, trial.count] = integrate (system, frame_times (plane), solver);
  none = 0*states(1:system.n,:);
  fields = system.fields (states(1:system.n,:), none, none, linspace (0, scene.rod.length, 21).');
  [trial.x, ~, trial.y] = system.surface.position (fields);
endfunction

%!test # a rod that hardly bends: the rigid pendulum
%! scene = setfield (setfield (swing (), "duration", 0.1), "frames_per_second", 20);
%! scene = setfield (check_scene (scene), "solver", "tolerance", 1e-4);
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! assert (distance (exact_rod (scene, 5), trial_run (scene, rung)) < 1e-4);
%!test # a tip mass it has not
%! assert (exact_rod (check_scene (setfield (swing (), "tip_mass", 1)), 5), []);
%!error <given up after 0 s>
%! exact_rod (setfield (check_scene (swing ()), "solver", "tolerance", 1e-4), 5, 0);
