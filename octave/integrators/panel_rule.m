## -*- texinfo -*-
## @deftypefn {} {@var{rule} =} panel_rule (@var{m})
## What @code{integrate_waveform} takes of a function on a panel: its values at @var{m} of Chebyshev's points from 0 to
## 1, ends included.  @var{rule} is a struct of nodes (1-by-m), weights (m-by-m: these times values, a column, are the
## coefficients of Chebyshev's polynomials of degree 0 and on) and defect (m-by-m: values, a row, times this are what
## the polynomial of the highest degree has of them).
## @end deftypefn

function rule = panel_rule (m)
  angles = pi*(0:m-1)/(m - 1);
  rule.nodes = (1 - cos (angles))/2;
  chebyshev = cos ((0:m-1).'.*(pi - angles));  # a row a degree
  rule.weights = inv (chebyshev.');
  rule.defect = inv (chebyshev)*diag ([zeros(1, m-1), 1])*chebyshev;
endfunction

%!test # 3 + 2 T_1 + 5 T_3 on four points
%! rule = panel_rule (4);
%! assert (rule.nodes, [0 0.25 0.75 1], 1e-15);
%! x = 2*rule.nodes - 1;
%! values = 3 + 2*x + 5*(4*x.^3 - 3*x);
%! assert (rule.weights*values.', [3; 2; 0; 5], 1e-14);
%! assert (values*rule.defect, 5*(4*x.^3 - 3*x), 1e-14);
