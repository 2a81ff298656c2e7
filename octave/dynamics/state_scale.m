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
             abs(scene.moment (linspace (0, scene.duration, 1000)))];
  energy = max (moments)/model.length;
  scale = [amplitudes; rates; energy; energy];
endfunction

%!test
%! scene = check_scene (setfield (paper (), "model", "modes", [0 1]));
%! scale = state_scale (build_model (scene, rung_of_scene (scene)), scene, [1; 1]);
%! assert (numel (scale), 6);
%! assert (scale(4), 1/1.8*7800*6e-4*(1/3 + 0.015^2/3), 1e-12);
