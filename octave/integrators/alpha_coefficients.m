## -*- texinfo -*-
## @deftypefn {} {@var{c} =} alpha_coefficients (@var{rho})
## The coefficients m, f, gamma, beta of the generalized-alpha method that damps what is far beyond the step to
## @var{rho} (0 to 1) in a step (Chung and Hulbert, J. Appl. Mech. 60, 1993), and part = (1 - f)/(1 - m).
## @end deftypefn

function c = alpha_coefficients (rho)
  c = struct ("m", (2*rho - 1)/(rho + 1), "f", rho/(rho + 1));
  c.gamma = 1/2 + c.f - c.m;
  c.beta = (c.gamma + 1/2)^2/4;
  c.part = (1 - c.f)/(1 - c.m);
endfunction

%!assert (alpha_coefficients (1).gamma, 1/2)
