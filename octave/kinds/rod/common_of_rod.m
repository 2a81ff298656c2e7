## -*- texinfo -*-
## @deftypefn {} {@var{system} =} common_of_rod (@var{scene}, @var{model}, @var{constants})
## What the system of a hinged rod and that of a rod in a hub have alike, of a checked @var{scene} and the
## @var{constants} of @code{rod_constants}: the fields of @code{hinged_rod} that hang neither on the rows of its state
## nor on what turns it.
## @end deftypefn

function system = common_of_rod (scene, model, constants)
  n = columns (model.basis);
  system.energies = @(phi, phi_dot, q, q_dot) rod_energies_of (phi, phi_dot, q, q_dot, constants);
  steepest = largest_slopes (model, model.basis);
  system.steepest = @(y) steepest (y(1:n));
  system.turned = isempty (model.rung.sines);
  system.auto = "waveform";
  system.warnings = {};
  system.duration = scene.duration;
  system.gravity = scene.gravity;
  system.force = scene.force;
  system.joined = constants.joined;
  system.longest_step = longest_step (model);
  system.breaks = scene.breaks;
endfunction

%!test # of one rod, in a hub and hinged
%! hub = check_scene (setfield (spin_up (), "model", "modes", [0 2]));
%! hinged = check_scene (setfield (setfield (rmfield (spin_up (), "rotation"), "model", "modes", [0 2]), "gravity", 2));
%! for scene = {hub, hinged}
%!   system = rod_system (scene{1}, build_model (scene{1}, rung_of_scene (scene{1})));
%!   assert (system.duration, scene{1}.duration); assert (system.gravity, scene{1}.gravity);
%!   assert (system.breaks, scene{1}.breaks); assert (system.auto, "waveform"); assert (! system.turned);
%!   assert (system.steepest (zeros (6, 1)), 0); assert (system.steepest ([0; 0.1; 0; 0; 0; 0]) > 0);
%! endfor
