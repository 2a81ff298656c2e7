## -*- texinfo -*-
## @deftypefn {} {@var{R} =} stability_function (@var{method})
## The stability function of an explicit Runge-Kutta @var{method}, rk4, ode45 or ode23, as a polynomial:
## y' = lambda y becomes R (h lambda) y in a step of h.  Its coefficients are 1 and b.A^k.1 of the tableau (Hairer and
## Wanner, Solving Ordinary Differential Equations II, IV.2).  Empty for other methods.
## @end deftypefn

function R = stability_function (method)
  switch (method)
    case "rk4"
      A = diag ([1/2 1/2 1], -1);
      b = [1/6 1/3 1/3 1/6];
    case "ode45"  # Dormand and Prince, J. Comput. Appl. Math. 6 (1980)
      A = zeros (6);
      A(2,1) = 1/5;
      A(3,1:2) = [3/40, 9/40];
      A(4,1:3) = [44/45, -56/15, 32/9];
      A(5,1:4) = [19372/6561, -25360/2187, 64448/6561, -212/729];
      A(6,1:5) = [9017/3168, -355/33, 46732/5247, 49/176, -5103/18656];
      b = [35/384, 0, 500/1113, 125/192, -2187/6784, 11/84];
    case "ode23"  # Bogacki and Shampine, Appl. Math. Lett. 2 (1989)
      A = diag ([1/2, 3/4], -1);
      b = [2/9, 1/3, 4/9];
    otherwise
      R = [];
      return;
  endswitch
  R = 1;
  power = ones (rows (A), 1);
  for k = 1:rows (A)
    R = [b*power, R];
    power = A*power;
  endfor
endfunction

%!assert (stability_function ("rk4"), 1./[24 6 2 1 1], 1e-15)
%!assert (stability_function ("ode45"), 1./[600 120 24 6 2 1 1], 1e-15)
%!assert (stability_function ("ode23"), 1./[6 2 1 1], 1e-15)
