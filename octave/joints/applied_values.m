## -*- texinfo -*-
## @deftypefn {} {@var{values} =} applied_values (@var{loads}, @var{t})
## What the @var{loads} of joints (see @code{list_springs}) are at the times @var{t} (1-by-k): a cell a load of F_x,
## F_y (N), M (N m; 3-by-k).
## @end deftypefn

function values = applied_values (loads, t)
  asked = 1:numel (t);
  if (numel (t) > 1 && all (t == t(1)))  # one instant is asked for once
    asked(:) = 1;
    t = t(1);
  endif
  values = cell (1, numel (loads));
  for j = 1:numel (loads)
    values{j} = zeros (3, numel (asked));
    values{j}(loads(j).parts,:) = reshape (loads(j).value (t), [], numel (t))(:,asked);
  endfor
endfunction

%!assert (applied_values (struct ("value", {@(t) 2*t, @(t) kron(t, [1 5])}, "parts", {3, [1 2]}), [1 2]), ...
%!        {[0 0; 0 0; 2 4], [1 2; 5 10; 0 0]})
%!assert (applied_values (struct ([]), 1), cell (1, 0))
%!test # of one instant a load is asked once
%! values = applied_values (struct ("value", @(t) rand (), "parts", 3), [2 2]);
%! assert (values{1}(3,1), values{1}(3,2)); assert (size (values{1}), [3 2]);
