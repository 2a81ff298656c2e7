## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{v}, @var{a}] =} alpha_update (@var{c}, @var{h}, @var{x}, @var{v}, @var{a}, @
##   @var{v_dot}, @var{next})
## Where the generalized-alpha method with the coefficients @var{c} (see @code{alpha_coefficients}) comes to in a step
## of @var{h} (s) from the places @var{x}, their rates @var{v} and auxiliary accelerations @var{a} on, where the
## accelerations are @var{v_dot} at its start and @var{next} at its end (each n-by-1).
## @end deftypefn

function [x, v, a] = alpha_update (c, h, x, v, a, v_dot, next)
  before = a;
  a = ((1 - c.f)*next + c.f*v_dot - c.m*before)/(1 - c.m);
  x = x + h*v + h^2*((1/2 - c.beta)*before + c.beta*a);
  v = v + h*((1 - c.gamma)*before + c.gamma*a);
endfunction

%!test # an even acceleration is met, whatever it damps
%! for rho = [0 0.5 1]
%!   [x, v, a] = alpha_update (alpha_coefficients (rho), 0.1, [1; 2], [3; 4], [5; 6], [5; 6], [5; 6]);
%!   assert ([x, v, a], [1.325 3.5 5; 2.43 4.6 6], 1e-14);
%! endfor
