## -*- texinfo -*-
## @deftypefn {} {@var{scale} =} like_stiffness (@var{M}, @var{K})
## Coordinates of like stiffness: y = @var{scale}.*z (p-by-1) has ones on the diagonal of its stiffness, where that of
## @var{K} (p-by-p) is not 0 beside the mass @var{M} and the largest square of a frequency.
## @end deftypefn

function scale = like_stiffness (M, K)
  largest = max ([abs(diag (K))./diag(M); 1e-99]);
  scale = 1./sqrt (abs (diag (K)) + 1e-16*largest*diag (M));
endfunction

%!assert (like_stiffness (diag ([1 4]), diag ([4 1e12])), [1/2; 1e-6], -1e-4)
%!assert (like_stiffness (diag ([1 4]), diag ([0 4e20])), [1e-2; 1/2e10], -1e-12)
%!assert (isfinite (like_stiffness (2, 0)))
