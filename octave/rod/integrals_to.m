## -*- texinfo -*-
## @deftypefn {} {@var{S} =} integrals_to (@var{axis}, @var{stations})
## The matrix (stations-by-p) that makes of values at the points of an @var{axis} (see @code{rod_axis}) the integrals
## from O to the @var{stations} (m), by the polynomials through each panel's points.
## @end deftypefn

function S = integrals_to (axis, stations)
  m = 8;
  nodes = gauss_rule (m);
  powers = nodes.'.^(0:m-1);
  S = zeros (numel (stations), numel (axis.xi));
  for i = 1:numel (stations)
    panel = find (axis.ends(1:end-1) <= stations(i), 1, "last");
    S(i,1:m*(panel-1)) = axis.weights(1:m*(panel-1));
    step = axis.ends(panel+1) - axis.ends(panel);
    s = (stations(i) - axis.ends(panel))/step;
    S(i,m*(panel-1)+(1:m)) = step*((s.^(1:m)./(1:m))/powers);
  endfor
endfunction

%!test
%! axis = struct ("ends", [0 1 3], "xi", [gauss_rule(8), 1 + 2*gauss_rule(8)]);
%! [~, w] = gauss_rule (8); axis.weights = [w, 2*w];
%! assert (integrals_to (axis, [0.5 2.5 3])*cos (axis.xi).', sin ([0.5; 2.5; 3]), 1e-8);
