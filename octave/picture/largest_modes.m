## -*- texinfo -*-
## @deftypefn {} {[@var{modes}, @var{names}] =} largest_modes (@var{V}, @var{names}, @var{most})
## The @var{most} rows of @var{V} (N-by-F) that grow largest, the largest first, and their @var{names}; none that stays
## below a thousandth of the largest, which would be drawn as zero.
## @end deftypefn

function [modes, names] = largest_modes (V, names, most)
  [~, order] = sort (max (abs (V), [], 2), "descend");
  order = order(1:min (most, end));
  reach = max (abs (V(order,:)), [], 2);
  order = order(reach > 1e-3*max ([reach; 0]));
  modes = V(order,:);
  names = names(order);
endfunction

%!test
%! [modes, names] = largest_modes ([1 -5; 0 1; 2 2; 3 0], {"V1_1", "V1_2", "V2_1", "V2_2"}, 2);
%! assert (modes, [1 -5; 3 0]);
%! assert (names, {"V1_1", "V2_2"});
%!assert (nthargout (2, @largest_modes, [1; 1e-4], {"V2_1", "V2_2"}, 2), {"V2_1"})
%!test
%! [modes, names] = largest_modes (zeros (0, 3), cell (1, 0), 4);
%! assert (modes, zeros (0, 3));
%!assert (nthargout (2, @largest_modes, [1; 2e-3], {"V2_1", "V2_2"}, 2), {"V2_1", "V2_2"})
%!assert (nthargout (2, @largest_modes, [20; 0.03], {"V2_1", "V2_2"}, 2), {"V2_1", "V2_2"})
%!assert (nthargout (2, @largest_modes, [0; 0], {"V2_1", "V2_2"}, 2), cell (1, 0))
%!assert (nthargout (2, @largest_modes, [2e-6; 1e-6], {"V2_1", "V2_2"}, 2), {"V2_1", "V2_2"})
