## -*- texinfo -*-
## @deftypefn {} {@var{factor} =} predicted_growth (@var{method}, @var{h_omega})
## By what a step h of an explicit @var{method} multiplies the amplitude of an oscillation of the frequency omega: its
## stability function (see @code{stability_function}), or the larger eigenvalue of a step of Stoermer and Verlet.
## @end deftypefn

function factor = predicted_growth (method, h_omega)
  R = stability_function (method);
  if (isempty (R))
    step = [1 - h_omega^2/2, h_omega; -h_omega*(1 - h_omega^2/4), 1 - h_omega^2/2];
    factor = max (abs (eig (step)));
  else
    factor = abs (polyval (R, 1i*h_omega));
  endif
endfunction

%!assert (predicted_growth ("stormer_verlet", 1.5), 1, 1e-12)
%!assert (predicted_growth ("rk4", stability_limit ("rk4")), 1, 1e-9)
