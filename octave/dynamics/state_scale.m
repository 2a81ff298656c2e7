## -*- texinfo -*-
## @deftypefn {} {@var{scale} =} state_scale (@var{model}, @var{scene}, @var{amplitudes})
## What each state of a rod may be off by where a centreline point is off by 1 m: coordinates by @var{amplitudes},
## their rates by the lowest frequency as well, the angular momentum by what turns the rod by 1/length in the duration;
## work and dissipated energy by what loads and inertia do over the length.
##
## (With its own frequency, a stiff mode that ode45 takes at its limit of stability may carry an energy of 1e-3 of the
## largest.)
## @end deftypefn

function scale = state_scale (model, scene, amplitudes)
  a = model.arrays;
  n = columns (model.basis);
  rates = amplitudes/scene.duration*a.moment_of_inertia;
  rates(1:n) = amplitudes(1:n)*min ([sqrt(diag (a.stiffness_matrix)./diag (a.mass_matrix)); Inf]);
  moments = [a.moment_of_inertia/scene.duration^2, a.static_moment*abs(scene.gravity), ...
             abs(scene.moment (load_times (scene)))];
  energy = max (moments)/model.length;
  scale = [amplitudes; rates; energy; energy];
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
