## -*- texinfo -*-
## @deftypefn {} {@var{history} =} sample_history (@var{frames})
## A history, as @code{measure} has it, to test the pictures with: a rod of 1 m that turns once in 1.8 s and bends in a
## half wave.
## @end deftypefn

function history = sample_history (frames)
  t = linspace (0, 1.8, frames);
  phi = -pi/6 + 2*pi * (t/1.8).^2;
  wave = 5e-4 * sin (12*t);
  T = 0.78 * (4*pi*t/1.8^2).^2;
  Z = 23 * sin (phi);
  history = struct ("t", t, "phi", phi, "psi", phi + pi*wave, "phi_dot", 4*pi*t/1.8^2, ...
                    "tip_x", cos (phi), "tip_y", sin (phi), "T", T, "U", 1e6 * wave.^2, "Z", Z, ...
                    "W", T + Z - Z(1), "D", 0*t, "balance", 1e6 * wave.^2 + Z(1), ...
                    "V", [1e-7 * [cos(9*t); sin(9*t)]; wave; wave.^2], "torque", [], ...
                    "V_names", {{"V1_1", "V1_2", "V2_1", "V2_2"}});
endfunction

%!assert (sample_history (5).phi(1), -pi/6)
