## -*- texinfo -*-
## @deftypefn {} {[@var{matrix}, @var{unit}, @var{compliance}] =} radau_matrix (@var{g}, @var{h}, @var{M}, @var{K}, @
##   @var{D}, @var{J}, @var{S}, @var{springs})
## The matrix of Newton's iteration for stages of panels of @var{h} (s; see @code{radau_window}), where rates are
## @var{g} (1/s, a number or a matrix) times what q and v change by.
##
## Unknowns are q, v, lambda, mu and the tensions, these three in units of the mass (@var{unit}, kg), so that rows and
## columns are of like size.  Mass @var{M}, tangents @var{K} and @var{D} (n-by-n), @var{J} = Phi_q, and @var{S}, the
## derivatives of the elongations of the @var{springs} (see @code{spring_forces}); a spring's row is that of its
## elongation over the step, times its @var{compliance} (as the springs' stiffness).
## @end deftypefn

function [matrix, unit, compliance] = radau_matrix (g, h, M, K, D, J, S, springs)
  [c, n] = size (J);
  e = rows (S);
  diagonal = @(x) spdiags (x(:), 0, e, e);
  unit = full (mean (abs (diag (M))));
  compliance = unit./max (h*springs.stiffness + springs.damping, eps);
  no_ties = sparse (c, c);
  no_tie = sparse (c, n);
  no_spring = sparse (c, e);
  by_place = -diagonal (compliance.*springs.stiffness)*S;
  by_rate = -diagonal (compliance.*springs.damping)*S;
  J *= unit;
  matrix = [M*g, -M, no_tie.', J.', sparse(n, e)
            K, M*g + D, J.', no_tie.', unit*S.'
            J/h, no_tie, no_ties, no_ties, no_spring
            no_tie, J, no_ties, no_ties, no_spring
            by_place, by_rate, no_spring.', no_spring.', unit*diagonal(compliance)];
endfunction

%!test # what the rate does to a mass, and what a joint does to it
%! none = struct ("stiffness", zeros (0, 1), "damping", zeros (0, 1));
%! A = radau_matrix (3, 0.5, sparse (2), sparse (1), sparse (4), sparse (1), sparse (0, 1), none);
%! assert (full (A), [6 -2 0 2; 1 10 2 0; 4 0 0 0; 0 2 0 0]);
%!test # and a spring of 5 N/m with a damper of 2 N s/m, whose row is unit/(h k + d) = 4/9 times its tension's
%! springs = struct ("stiffness", 5, "damping", 2);
%! [A, unit, compliance] = radau_matrix (3, 0.5, sparse (2), sparse (1), sparse (4), sparse (0, 1), sparse (3), ...
%!   springs);
%! assert (unit, 2); assert (compliance, 4/9, 1e-15);
%! assert (full (A), [6 -2 0; 1 10 6; -4/9*5*3, -4/9*2*3, 2*4/9], 1e-14);
