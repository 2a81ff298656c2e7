## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} linear_frequencies (@var{scene})
## Frequencies (rad/s, ascending, without the free rotation) of the undeformed rod of @var{scene} without gravity.
## @end deftypefn

function omega = linear_frequencies (scene)
  scene = check_scene (scene);
  model = build_model (scene, rung_of_scene (scene));
  a = model.arrays;
  mass = mass_with_rotation (a);
  stiffness = blkdiag (a.stiffness_matrix, 0);
  omega = sort (sqrt (abs (eig (stiffness, mass))))(2:end);
endfunction

%!function scene = slender (half_height, energy, rotary_inertia, modes)
%!  scene = paper ();
%!  scene.rod.half_height = half_height; scene.model.energy = energy;
%!  scene.model.rotary_inertia = rotary_inertia; scene.model.modes = modes;
%!endfunction

%!function c = wave_speed (energy)
%!  [lambda, mu] = deal (1.2e11, 8.1e10);
%!  modulus = struct ("paper", 4*(lambda + mu), "uniaxial", mu*(3*lambda + 2*mu)/(lambda + mu));
%!  c = sqrt (modulus.(energy)/7800);
%!endfunction

%!test # the free pinned beam: beta l = 3.926602, 7.068583, 10.210176 to 0.1 % at N2 = 7, and converging
%! scene = slender (0.015, "uniaxial", false, [0 7]);
%! EI_per_rhoA = wave_speed ("uniaxial")^2*0.015^2/3;
%! expected = [3.926602; 7.068583; 10.210176].^2*sqrt (EI_per_rhoA);
%! seven = linear_frequencies (scene)(1:3)./expected - 1;
%! assert (abs (seven) < 1e-3);
%! scene.model.modes = [0 30];
%! thirty = linear_frequencies (scene)(1:3)./expected - 1;
%! assert (abs (thirty) < abs (seven)/10 + 3e-7);

%!test # longitudinal frequencies (2k - 1) pi/2 c/l in both energies, up to (h/l)^2
%! for energy = {"paper", "uniaxial"}
%!   expected = (2*(1:5).' - 1)*pi/2*wave_speed (energy{1});
%!   for rotary_inertia = [true, false]
%!     deviation = @(h) abs (linear_frequencies (slender (h, energy{1}, rotary_inertia, [5 0]))./expected - 1);
%!     assert (deviation (1e-4) < 1e-5);
%!     assert (deviation (0.01) <= 1.1/4*deviation (0.02) + 1e-12);
%!   endfor
%! endfor
