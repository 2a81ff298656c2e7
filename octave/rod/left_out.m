## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} left_out (@var{model}, @var{V}, @var{part}, @var{count})
## How far the points of a @var{model}'s centreline are (m), in motions of the amplitudes @var{V} (N-by-m), from where
## the same forces at rest would have them in a model with no more than the first @var{count} of a @var{part} of its
## base functions, 1: longitudinal, 2: bending.  Functions with numbers below 0, corrections for the ends, are there
## while any is.
## @end deftypefn

function metres = left_out (model, V, part, count)
  base = model.base;
  numbers = [base.longitudinal, base.transversal];
  of_part = repelem ([1 2], [numel(base.longitudinal), numel(base.transversal)]) == part;
  dropped = of_part & (numbers > count | count == 0);
  [along, across] = functions_at (base, linspace (0, model.length, 21));
  K = model.arrays.stiffness_matrix;
  V(dropped,:) *= -1;
  V(! dropped,:) = -K(! dropped,! dropped) \ (K(! dropped,dropped)*V(dropped,:));
  metres = max ([0; hypot(along*V, across*V)(:)]);
endfunction

%!function model = of_functions (longitudinal, transversal)   # of a rod of 2 m
%!  model = struct ("base", base_functions (longitudinal, transversal, 2), "length", 2);
%!  section = struct ("rhoA", 1, "rhoI", 0, "EA", 50, "EI", 3, "GI", 0);
%!  model.arrays = rod_arrays (model.base, section, 0);
%!endfunction
%!test # the third sine
%! model = of_functions (1, [1 2 3]);
%! V = [0.5; 1e-2; 2e-2; 3e-2];
%! assert (left_out (model, V, 2, 2), 3e-2, 1e-3);
%! assert (left_out (model, V, 2, 3), 0);
%! assert (left_out (model, V, 1, 0), 0.5, 1e-12);
%!test # with the sines the corrections
%! model = of_functions (1, [1 2 3 -1]);
%! assert (left_out (model, [0; 0; 0; 0; 1], 2, 1), 0); assert (left_out (model, [0; 0; 0; 0; 1], 2, 0) > 0.1);
%!test # under a force inside: what the static shape of the functions that are left has not
%! model = of_functions (1, [1:5, -1, -2]);
%! [~, force] = functions_at (model.base, 0.7);
%! [~, across] = functions_at (model.base, linspace (0, 2, 21));
%! K = model.arrays.stiffness_matrix;
%! shape = @(kept) across(:,kept)*(K(kept,kept) \ force(kept).');
%! assert (left_out (model, K \ force.', 2, 2), max (abs (shape (1:8) - shape ([1:3 7 8]))), 1e-12);
