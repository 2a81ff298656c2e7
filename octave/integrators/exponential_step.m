## -*- texinfo -*-
## @deftypefn {} {@var{step} =} exponential_step (@var{omega}, @var{damping}, @var{h}, @var{extra})
## The functions of an exponential method's step @var{h} (s) for oscillators eta_ddot + damping eta_dot + omega^2 eta
## (n-by-1 each, rad/s and 1/s) in the form z = (eta; eta_dot; w) with @var{extra} states w.
##
## Fields: h, swap, and half and whole, with what z becomes over h/2 and h by itself and by a load R that is constant,
## linear and quadratic in time: free, phi1, phi2, phi3, each of two columns for z.*first + z(swap).*second.
## @end deftypefn

function step = exponential_step (omega, damping, h, extra)
  n = numel (omega);
  step.h = h;
  step.swap = [n+1:2*n, 1:n, 2*n+(1:extra)];
  step.half = motion (omega, damping, h/2, extra);
  step.whole = motion (omega, damping, h, extra);
endfunction

function f = motion (omega, damping, h, extra)
  [same, other] = oscillator_functions (omega, damping, repmat (h, size (omega)), 3);
  names = {"free", "phi1", "phi2", "phi3"};
  for k = 0:3
    scale = h^(k > 0);
    constant = scale/[1 1 2 6](k+1);
    f.(names{k+1}) = [[scale*same(:,k+1); scale*(same(:,k+1) - damping.*other(:,k+1)); ones(extra, 1)*constant], ...
                      [scale*other(:,k+1); -scale*omega.^2.*other(:,k+1); zeros(extra, 1)]];
  endfor
endfunction

%!function z = after (step, f, z)
%!  z = f(:,1).*z + f(:,2).*z(step.swap);
%!endfunction
%!test # a quarter of a turn, and rest under a constant load
%! step = exponential_step (2, 0, pi/4, 1);
%! z = after (step, step.whole.free, [1; 0; 5]);
%! assert (z, [0; -2; 5], 1e-14);
%! assert (z + after (step, step.whole.phi1, [0; 4; 3]), [1; 0; 5 + 3*pi/4], 1e-14);
%!test # a damped oscillator, as the matrix exponential has it
%! step = exponential_step (3, 0.5, 0.7, 0);
%! f = step.whole.free;
%! assert ([f(1,1), f(1,2); f(2,2), f(2,1)], expm (0.7*[0 1; -9 -0.5]), 1e-12);
