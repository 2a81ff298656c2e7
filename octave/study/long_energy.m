## -*- texinfo -*-
## @deftypefn {} {@var{found} =} long_energy (@var{method}, @var{h_omega}, @var{periods})
## The energy of the freely turning rod with one bending mode over so many @var{periods} of its free bending vibration,
## by a @var{method} in steps h, h*omega = @var{h_omega}: a struct of periods (1-by-1001) and error (of the energy, as
## a part of it), slope (per period, of a fitted line), slope_deviation (its standard deviation) and amplitude (largest
## deviation from the line).
## @end deftypefn

function found = long_energy (method, h_omega, periods)
  system = free_rod ([0 1], struct ("phi_dot", 20, "V2", 2e-3));
  omega = highest_frequency (system);
  times = linspace (0, periods*2*pi/omega, 1001);
  states = integrate (system, times, struct ("name", method, "tolerance", 1, "step", h_omega/omega, ...
                                             "rho_infinity", 1));
  motion = system.motion (times, states);
  E = sum (system.energies (motion.phi, motion.phi_dot, motion.q, motion.q_dot), 1);
  found.periods = times*omega/(2*pi);
  found.error = E/E(1) - 1;
  A = [ones(1001, 1), found.periods.'];
  line = A \ found.error.';
  rest = found.error.' - A*line;
  found.slope = line(2);
  found.slope_deviation = sqrt (sumsq (rest)/999*inv (A.'*A)(2,2));
  found.amplitude = max (abs (rest));
endfunction

%!test # Stoermer and Verlet: bounded, shrinking as the square of the step; the classical method loses it
%! coarse = long_energy ("stormer_verlet", 0.2, 20);
%! fine = long_energy ("stormer_verlet", 0.1, 20);
%! assert (log2 (coarse.amplitude/fine.amplitude), 2, 0.2);
%! lost = long_energy ("rk4", 0.5, 50);
%! assert (lost.slope < -3*lost.slope_deviation);
%! ## the error begins with 0, and of the line through it the largest rest is the amplitude
%! assert (coarse.periods([1 end]), [0 20], 1e-9); assert (coarse.error(1), 0);
%! [p, S] = polyfit (coarse.periods, coarse.error, 1);
%! assert (coarse.slope, p(1), 1e-6*abs (p(1)) + 1e-15);
%! assert (coarse.amplitude, max (abs (coarse.error - polyval (p, coarse.periods))), 1e-6*coarse.amplitude);
%! assert (coarse.slope_deviation, sqrt (S.normr^2/999)/norm (coarse.periods - 10), 1e-6*coarse.slope_deviation);
