## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} newton_condition (@var{system}, @var{start}, @var{steps})
## The condition of the matrix of Newton's iteration on index 3 of a mechanism's @var{system} at its @var{start} (q and
## v) with each of the @var{steps} (s), as it stands and scaled as @code{index3_alpha} takes it: rows of method, what,
## predicted (NaN) and measured.
## @end deftypefn

function rows = newton_condition (system, start, steps)
  [mass, jacobian] = system.matrices (system.at (0, start.q, start.v));
  J = full (jacobian);
  unit = mean (diag (mass));
  none = zeros (size (J, 1));
  rows = cell (0, 4);
  for h = steps
    tangent = full (mass/(h^2/4) + system.stiffness);
    plain = cond ([tangent, J.'; J, none]);
    scaled = cond ([h^2/4*tangent, J.'*unit; J*unit, none]);
    rows(end+1,:) = {"generalized_alpha, index 3", sprintf("condition of Newton's matrix, h = %g s", h), NaN, plain};
    rows(end+1,:) = {"generalized_alpha, index 3", sprintf("the same, scaled, h = %g s", h), NaN, scaled};
  endfor
endfunction

%!test # two masses, one of them held: [4/h^2 1; 1 0] and [1 1; 1 0] beside what the other has alone
%! system = struct ("stiffness", 0, "at", @(t, q, v) 0, "matrices", @(at) deal (eye (2), [1 0]));
%! rows = newton_condition (system, struct ("q", [0; 0], "v", [0; 0]), 0.02);
%! assert ([rows{:,4}], [1e8, (3 + sqrt(5))/2], -1e-6);
