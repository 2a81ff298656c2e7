## -*- texinfo -*-
## @deftypefn {} {@var{D} =} imaginary_steps (@var{f}, @var{size}, @var{t}, @var{x}, @dots{})
## Derivatives of @var{f} (t, step, x, @dots{}) by its step at k times @var{t} and arguments (n-by-k each), all of them
## in one call: n-by-n-by-k.
##
## They are the imaginary part after an imaginary step of the @var{size} (Squire and Trapp, SIAM Review 40, 1998):
## nothing is subtracted, so that the step can be as small as it likes, and D is exact to rounding, of an analytic f.
## @end deftypefn

function D = imaginary_steps (f, size_of, t, varargin)
  [n, k] = size (varargin{1});
  all_of = cellfun (@(x) repmat (x, 1, n), varargin, "uniformoutput", false);
  moved = f (t, 1i*size_of*kron (eye (n), ones (1, k)), all_of{:});
  D = permute (reshape (imag (moved)/size_of, n, k, n), [1 3 2]);
endfunction

%!test # of what does not hang on time, and of each column by itself
%! A = [1 2; 3 4];
%! D = imaginary_steps (@(t, step, x) A*(x + step).^2, 1e-30, [0 0 0], [1 2 3; 4 5 6]);
%! assert (D(:,:,2), A*diag ([4 10]), 1e-12); assert (size (D), [2 2 3]);
