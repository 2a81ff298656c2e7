## -*- texinfo -*-
## @deftypefn {} {@var{rule} =} radau_rule (@var{s})
## Radau IIA of @var{s} stages, odd (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8):
## collocation at the zeros of d^(s-1)/dx^(s-1) (x^(s-1) (x - 1)^s), a struct of c (1-by-s), A (s-by-s), inverse (of
## A), its eigenvectors T and eigenvalues (the real one, then the pairs, each from above the axis) and e (1-by-s, the
## error formula's weights of what the stages have beyond the start).
## @end deftypefn

function rule = radau_rule (s)
  p = 1;
  for k = 1:2*s-1
    p = conv (p, [1, -(k > s - 1)]);
  endfor
  for k = 1:s-1
    p = polyder (p);
  endfor
  rule.c = sort (real (roots (p))).';
  rule.c(s) = 1;
  powers = rule.c.'.^(0:s-1);
  rule.A = (rule.c.'.^(1:s)./(1:s))/powers;
  rule.inverse = inv (rule.A);
  [rule.T, eigenvalues] = eig (rule.inverse);
  eigenvalues = diag (eigenvalues);
  [~, order] = sort (1e3*abs (imag (eigenvalues)) - imag (eigenvalues));
  rule.T = rule.T(:,order);
  rule.eigenvalues = eigenvalues(order);
  first = zeros (1, s);
  first(1) = 1;
  rule.e = -(first/powers)*rule.inverse;
endfunction

%!test # the method of three stages, as Hairer and Wanner print it (IV.5, table 5.6)
%! rule = radau_rule (3);
%! assert (rule.c, [(4 - sqrt(6))/10, (4 + sqrt(6))/10, 1], 1e-14);
%! assert (rule.A(3,:), [(16 - sqrt(6))/36, (16 + sqrt(6))/36, 1/9], 1e-14);
%! assert (rule.T*diag (rule.eigenvalues)/rule.T, rule.inverse, 1e-12);
%!test # integrals of polynomials up to the order
%! rule = radau_rule (5);
%! for k = 0:8
%!   assert (rule.A(5,:)*rule.c.'.^k, 1/(k + 1), 1e-13);
%! endfor
%!test # the weights of its error, as Hairer and Wanner print them (IV.8, (8.19) and (8.20))
%! assert (radau_rule (3).e, [-13 - 7*sqrt(6), -13 + 7*sqrt(6), -1]/3, 1e-13);
