## -*- texinfo -*-
## @deftypefn {} {@var{step} =} exponential_step (@var{omega}, @var{h}, @var{extra})
## The functions of an exponential method's step @var{h} (s) for oscillators of frequencies @var{omega} (n-by-1, rad/s) in
## the form z = (eta; eta_dot; w) with @var{extra} states w.
##
## Fields: h, swap, and half and whole, with what z becomes over h/2 and h by itself and by a load R that is constant,
## linear and quadratic in time: free, phi1, phi2, phi3, each of two columns for z.*first + z(swap).*second.
## @end deftypefn

function step = exponential_step (omega, h, extra)
  n = numel (omega);
  step.h = h;
  step.swap = [n+1:2*n, 1:n, 2*n+(1:extra)];
  step.half = motion (omega, h/2, extra);
  step.whole = motion (omega, h, extra);
endfunction

function f = motion (omega, h, extra)
  c = stumpff ((omega*h).^2);
  names = {"free", "phi1", "phi2", "phi3"};
  for k = 0:3
    same = h^(k > 0)*c(:,k+1);
    other = h^(1 + (k > 0))*c(:,k+2);
    constant = h^(k > 0)/[1 1 2 6](k+1);
    f.(names{k+1}) = [[same; same; ones(extra, 1)*constant], [other; -omega.^2.*other; zeros(extra, 1)]];
  endfor
endfunction

%!function z = after (step, f, z)
%!  z = f(:,1).*z + f(:,2).*z(step.swap);
%!endfunction
%!test # a quarter of a turn, and rest under a constant load
%! step = exponential_step (2, pi/4, 1);
%! z = after (step, step.whole.free, [1; 0; 5]);
%! assert (z, [0; -2; 5], 1e-14);
%! assert (z + after (step, step.whole.phi1, [0; 4; 3]), [1; 0; 5 + 3*pi/4], 1e-14);
