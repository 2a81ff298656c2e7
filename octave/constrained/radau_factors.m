## -*- texinfo -*-
## @deftypefn {} {@var{factors} =} radau_factors (@var{rule}, @var{h}, @var{M}, @var{K}, @var{D}, @var{J}, @var{S}, @
##   @var{springs})
## The factorised matrices of Newton's iteration in a step of @var{h} (s) of @code{radau_step}, one for the real
## eigenvalue of the @var{rule} and one for each pair: a struct of L, U, P, Q (cells), h, unit (kg), compliance
## (springs-by-1).
##
## Unknowns are q, v, lambda, mu and the tensions, these three in units of the mass, so that rows and columns are of
## like size.  Mass @var{M}, tangents @var{K} and @var{D} (n-by-n), @var{J} = Phi_q, and @var{S}, the derivatives of
## the elongations of the @var{springs} (see @code{spring_forces}); a spring's row is that of its elongation over the
## step.
## @end deftypefn

function factors = radau_factors (rule, h, M, K, D, J, S, springs)
  [c, n] = size (J);
  e = rows (S);
  diagonal = @(x) spdiags (x, 0, e, e);
  unit = full (mean (abs (diag (M))));
  compliance = unit./max (h*springs.stiffness + springs.damping, eps);
  [no_ties, no_tie, no_spring] = deal (sparse (c, c), sparse (c, n), sparse (c, e));
  by_place = -diagonal (compliance.*springs.stiffness)*S;
  by_rate = -diagonal (compliance.*springs.damping)*S;
  factors = struct ("h", h, "unit", unit, "compliance", compliance);
  J *= unit;
  for i = 1:(numel (rule.c) + 1)/2
    g = rule.eigenvalues(2*i - 2 + (i == 1))/h;
    matrix = [g*M, -M, no_tie.', J.', sparse(n, e)
              K, g*M + D, J.', no_tie.', unit*S.'
              J/h, no_tie, no_ties, no_ties, no_spring
              no_tie, J, no_ties, no_ties, no_spring
              by_place, by_rate, no_spring.', no_spring.', unit*diagonal(compliance)];
    [factors.L{i}, factors.U{i}, factors.P{i}, factors.Q{i}] = lu (matrix);
  endfor
endfunction

%!test # a mass on a spring and damper: M (v' = g v) and what the spring does of it
%! rule = struct ("c", 1, "eigenvalues", 2);
%! springs = struct ("stiffness", 7, "damping", 3);
%! f = radau_factors (rule, 0.5, sparse (2), sparse (1), sparse (0), sparse (0, 1), sparse (1), springs);
%! x = f.Q{1}*(f.U{1} \ (f.L{1} \ (f.P{1}*[0; 1; 0])));
%! assert (x(3)*f.unit, 7*x(1) + 3*x(2), 1e-12);
%! assert (x(2), 4*x(1), 1e-12);
%! assert (x(1) + 8*x(2) + x(3)*f.unit, 1, 1e-12);
