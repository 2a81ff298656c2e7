## -*- texinfo -*-
## @deftypefn {} {[@var{modes}, @var{names}] =} largest_modes (@var{V1}, @var{V2}, @var{most})
## The @var{most} rows of @var{V1} (N1-by-F) and @var{V2} (N2-by-F) that grow largest, the largest first, and their
## @var{names} as in the history, such as V2_1.
## @end deftypefn

function [modes, names] = largest_modes (V1, V2, most)
  modes = [V1; V2];
  names = [arrayfun(@(j) sprintf ("V1_%d", j), 1:rows (V1), "UniformOutput", false), ...
           arrayfun(@(j) sprintf ("V2_%d", j), 1:rows (V2), "UniformOutput", false)];
  [~, order] = sort (max (abs (modes), [], 2), "descend");
  order = order(1:min (most, end));
  modes = modes(order,:);
  names = names(order);
endfunction

%!test
%! [modes, names] = largest_modes ([1 -5; 0 1], [2 2; 3 0], 2);
%! assert (modes, [1 -5; 3 0]);
%! assert (names, {"V1_1", "V2_2"});
%!test # a rigid rod has none
%! [modes, names] = largest_modes (zeros (0, 3), zeros (0, 3), 4);
%! assert (modes, zeros (0, 3));
%! assert (isempty (names));
