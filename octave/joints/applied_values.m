## -*- texinfo -*-
## @deftypefn {} {@var{values} =} applied_values (@var{loads}, @var{t})
## What the @var{loads} of joints (see @code{list_springs}) are at the times @var{t} (1-by-k): a cell a load of F_x,
## F_y (N), M (N m; 3-by-k).
## @end deftypefn

function values = applied_values (loads, t)
  values = cell (1, numel (loads));
  for j = 1:numel (loads)
    values{j} = zeros (3, numel (t));
    values{j}(loads(j).parts,:) = at_times (loads(j).value, t);
  endfor
endfunction

%!assert (applied_values (struct ("value", {@(t) 2*t, @(t) [t 5]}, "parts", {3, [1 2]}), [1 2]), ...
%!        {[0 0; 0 0; 2 4], [1 2; 5 5; 0 0]})
%!assert (applied_values (struct ([]), 1), cell (1, 0))
