## -*- texinfo -*-
## @deftypefn {} {@var{system} =} rod_system (@var{scene}, @var{model})
## The system of first order that moves the scene's rod: @code{hub_rod} where its rotation is prescribed, else
## @code{hinged_rod}; it starts as the scene has it, or in equilibrium.  The scene's solver is refused where the system
## has no form for it.
## @end deftypefn

function system = rod_system (scene, model)
  kinds = {@hinged_rod, @hub_rod};
  system = kinds{2 - isempty(scene.rotation)} (scene, model);
  method_of (system, scene.solver.name);
  if (strcmp (scene.initial.from, "equilibrium") && rows (system.mass) > 0)  # a rigid rod in a hub is where that is
    q = equilibrium (rod_at_rest (model, system), 0);
    system.initial_state = system.accelerations.state ([q; 0*q; 0; 0]);
  endif
  if (! isempty (system.joined))
    start = system.motion (0, system.initial_state);
    refuse_coincident (scene.joints, system.joined, marker_places (system.joined, [start.q; start.phi; 0; 0]));
  endif
endfunction

%!test # a hinged rod falls from rest by 3/2 g/l (less what its height takes), a hub's rod is where the hub is
%! [scene, model] = sample_rod ([0 0], "moment", 0, "initial.phi", 0);
%! system = rod_system (scene, model);
%! t = 1e-3;
%! phi = integrate (system, [0 t], struct ("name", "auto", "tolerance", 1e-12))(1,2);
%! assert (phi, -1.5*9.81/(1 + 0.015^2)*t^2/2, 1e-5*t^2);
%! scene = check_scene (setfield (setfield (spin_up (), "model", "modes", [0 1]), "rotation", @(t) [3*t, 3, 0]));
%! system = rod_system (scene, build_model (scene, rung_of_scene (scene)));
%! motion = system.motion ([0 2], [system.initial_state, system.initial_state]);
%! assert ([motion.phi; motion.phi_dot], [0 6; 3 3], 1e-12);
%!test # a rigid rod in a hub that stands is in equilibrium as it is
%! scene.rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1, "half_height", 0.01);
%! [scene.duration, scene.rotation, scene.initial] = deal (0.1, @(t) [0.3 0 0], "equilibrium");
%! scene.model.modes = [0 0];
%! assert (driver (scene, "output", "").history.tip_y, sin (0.3)*ones (1, 6), 1e-12);
