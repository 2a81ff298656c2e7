## -*- texinfo -*-
## @deftypefn {} {[@var{squares}, @var{shape}] =} undamped_modes (@var{M}, @var{K})
## The modes of M y'' + K y = 0, both symmetric (p-by-p): squares of frequencies (1-by-p, rising, 0 where the rounding
## of @var{K} has as much, see @code{noise_of}; negative where it grows) and shapes (p-by-p).
##
## The slow ones have full relative accuracy beside stiff ones: 1/(square + shift) are eigenvalues of M by K + shift M
## in coordinates of like stiffness.  The fast ones are those of K by M, where these are more accurate, and so are all
## of a mass that is not positive, which no shift helps (see @code{refuse_negative_mass}).
## @end deftypefn

function [squares, shape] = undamped_modes (M, K)
  scale = like_stiffness (M, K);
  [M, K] = deal (M.*(scale*scale.'), K.*(scale*scale.'));
  [shape, squares] = free_modes (K, M);
  squares = squares.';
  [~, indefinite] = chol (M);
  if (indefinite)
    shape .*= scale;
    return;
  endif
  shift = positive_shift (M, K);
  [slow, slow_shape] = inverted (M, K, shift);
  if (shift > 0)
    shift = max ([shift, min(abs (slow(slow != 0)))]);
    [slow, slow_shape] = inverted (M, K, shift);
  endif
  border = sqrt (max (squares)*(shift + max (slow(1), 0)));
  kept = 1:sum (slow <= border);
  squares(kept) = slow(kept);
  shape(:,kept) = slow_shape(:,kept);
  shape .*= scale;
endfunction

## none where K is positive definite, more than rounding has; else up to two hundred times what makes it so
function shift = positive_shift (M, K)
  shift = 0;
  while (nthargout (2, @chol, K + shift/2*M - 1e-12*eye (rows (K))) > 0)
    shift = max (100*shift, 1e-10/norm (M));
  endwhile
endfunction

function [squares, shape] = inverted (M, K, shift)
  [shape, inverse] = free_modes (M, K + shift*M);
  [shape, inverse] = deal (fliplr (shape), flipud (inverse).');
  squares = 1./max (inverse, eps*inverse(1)) - shift;
  squares(abs (squares) < max (noise_of (shape, M, K).^2, 1e-13*shift)) = 0;
endfunction

%!test # a slow one beside a stiff one of 20 powers, both accurate, with and without a motion that nothing brings back
%! for neutral = [0.3 0]
%!   [squares, shape] = undamped_modes (diag ([5 1 1]), diag ([5*4e20 40 neutral]));
%!   assert (squares, [neutral 40 4e20], -1e-12); assert (abs (shape./max (abs (shape))), eye (3)(:,[3 2 1]), 1e-9);
%! endfor
%!test # masses that are coupled by stiff springs move as one: nothing brings them back, and it is no growth
%! K = 1e15*[1 -1 0; -1 2 -1; 0 -1 1];
%! K(1,1) -= 0.5;
%! assert (undamped_modes (diag ([1 2 3]), K)(1), 0);
%!test # what grows beside what is stiff
%! assert (undamped_modes (eye (3), diag ([-9 4 1e14])), [-9 4 1e14], -1e-12);
%!test # a mass that is not positive ends, too
%! [squares, shape] = undamped_modes (diag ([1 -1]), diag ([2 -3]));
%! assert (sort (squares), [2 3], 1e-12);
