## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} left_out (@var{model}, @var{V}, @var{part}, @var{count})
## How far the points of a @var{model}'s centreline move (m) by those amplitudes @var{V} (N-by-m) of a @var{part} of
## its base functions, 1: longitudinal, 2: bending, that a model with the first @var{count} of them has not.  Functions
## with numbers below 0, corrections for the ends, are there while any is.
## @end deftypefn

function metres = left_out (model, V, part, count)
  base = model.base;
  numbers = [base.longitudinal, base.transversal];
  of_part = repelem ([1 2], [numel(base.longitudinal), numel(base.transversal)]) == part;
  dropped = of_part & (numbers > count | count == 0);
  [along, across] = functions_at (base, linspace (0, model.length, 21));
  metres = max ([0; hypot(along(:,dropped)*V(dropped,:), across(:,dropped)*V(dropped,:))(:)]);
endfunction

%!test # the third sine, and with the sines the correction
%! model = struct ("base", base_functions (1, [1 2 3 -1], 2), "length", 2);
%! V = [0.5; 1e-2; 2e-2; 3e-2; 0];
%! assert (left_out (model, V, 2, 2), 3e-2, 1e-3);
%! assert (left_out (model, V, 2, 3), 0);
%! assert (left_out (model, V, 1, 0), 0.5);
%! V(5) = 1; V(2:4) = 0;
%! assert (left_out (model, V, 2, 1), 0); assert (left_out (model, V, 2, 0) > 0.1);
