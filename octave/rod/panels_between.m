## -*- texinfo -*-
## @deftypefn {} {@var{axis} =} panels_between (@var{ends})
## The points of Gauss along a rod, eight on each panel between the @var{ends} (1-by-(k+1), m), as
## @code{integrals_to} takes them: a struct of ends, xi and weights (1-by-8k, m).
## @end deftypefn

function axis = panels_between (ends)
  [nodes, weights] = gauss_rule (8);
  steps = diff (ends);
  axis.ends = ends;
  axis.xi = (ends(1:end-1) + steps.*nodes.')(:).';
  axis.weights = (steps.*weights.')(:).';
endfunction

%!test # integrals to anywhere, exact of polynomials on each panel
%! axis = panels_between ([0 0.7 2]);
%! assert (integrals_to (axis, [0.5 1.9])*axis.xi.'.^7, [0.5; 1.9].^8/8, 1e-13);
%! assert (sum (axis.weights), 2, 1e-14);
