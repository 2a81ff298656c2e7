## -*- texinfo -*-
## @deftypefn {} {@var{scale} =} state_scale (@var{model}, @var{scene}, @var{amplitudes})
## What each state of a rod may be off by where a centreline point is off by 1 m: coordinates by @var{amplitudes},
## their rates by the lowest frequency as well, the angular momentum by what turns the rod by 1/length in the duration;
## work and dissipated energy by what loads do over the length, in a motion that is as small as they make it.
##
## (With its own frequency, a stiff mode that ode45 takes at its limit of stability may carry an energy of 1e-3 of the
## largest.)
## @end deftypefn

function scale = state_scale (model, scene, amplitudes)
  a = model.arrays;
  n = columns (model.basis);
  rates = amplitudes/scene.duration*a.moment_of_inertia;
  rates(1:n) = amplitudes(1:n)*min ([sqrt(diag (a.stiffness_matrix)./diag (a.mass_matrix)); Inf]);
  energy = energy_of (largest_moment (scene, a), a.moment_of_inertia, scene.duration)/model.length;
  scale = [amplitudes; rates; energy; energy];
endfunction

## N m: of the weight, the moment, the force or the hub
function moment = largest_moment (scene, arrays)
  times = load_times (scene);
  moments = [arrays.static_moment*abs(scene.gravity), abs(scene.moment (times))];
  if (! isempty (scene.force))
    force = at_times (scene.force, times);
    moments = [moments, scene.force_station*hypot(force(1,:), force(2,:))];
  endif
  if (! isempty (scene.rotation))
    moments = [moments, arrays.moment_of_inertia*abs(at_times (scene.rotation, times)(3,:))];
  endif
  moment = max (moments);
endfunction

## J: its work on the angle by which it turns the rod, 1 at most; without a moment what turns it by 1 in the duration
function energy = energy_of (moment, inertia, duration)
  if (moment == 0)
    energy = inertia/duration^2;
  else
    energy = moment*min (1, moment*duration^2/inertia);
  endif
endfunction

%!function scale = of_rod (moment, gravity, amplitudes)   # of 2 m, 9.36 kg and 1.8 s, with half a wave
%!  scene = setfield (setfield (paper (), "model", "modes", [0 1]), "moment", moment);
%!  [scene.rod.length, scene.gravity, scene.model.energy] = deal (2, gravity, "uniaxial");
%!  scene.model.rotary_inertia = false;
%!  scene = check_scene (scene);
%!  scale = state_scale (build_model (scene, rung_of_scene (scene)), scene, amplitudes);
%!endfunction
%!test # coordinates, their rates by omega = pi^2/l^2 sqrt (EI/rhoA), angular momentum by J/duration
%! scale = of_rod (0, 0, [3; 5]);
%! E = 8.1e10*(3*1.2e11 + 2*8.1e10)/(1.2e11 + 8.1e10);
%! omega = pi^2/4*sqrt (E*0.02*0.03^3/12/(7800*6e-4));
%! assert (scale(1:4), [3; 5; 3*omega; 5*9.36*4/3/1.8], 1e-9*omega);
%!test # energies by the largest of what inertia, weight and moment do, over the length
%! assert (of_rod (0, 0, [1; 1])(5:6), 9.36*4/3/1.8^2/2*[1; 1], 1e-12);
%! assert (of_rod (0, -9.81, [1; 1])(5:6), 9.36*9.81/2*[1; 1], 1e-9);
%! assert (of_rod (@(t) -300*(t > 1), 1, [1; 1])(5:6), 150*[1; 1], 1e-9);
%!test # a force that moves the rod little: F station, on half F station T^2/J, and the moment of a hub
%! scene = struct ("length", 2, "EA", 1e6, "EI", 1e3, "rhoA", 1.5, "half_height", 0.01);  # J = 4 kg m^2
%! scene = struct ("rod", scene, "gravity", 0, "duration", 0.5, "model", struct ("modes", [0 0], "rotary_inertia", false));
%! energy_of = @(scene) state_scale (build_model (scene, rung_of_scene (scene)), scene, 1)(end);
%! pushed = check_scene (setfield (setfield (scene, "force", @(t) [3 4]*sin(pi*t/0.5)), "force_station", 0.4));
%! assert (energy_of (pushed), 2*(2*0.5^2/4)/2, 1e-5);
%! assert (energy_of (check_scene (setfield (scene, "rotation", @(t) [0.05*t^2, 0.1*t, 0.1]))), 0.4*(0.1*0.5^2)/2, 1e-12);
