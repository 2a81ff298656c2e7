## -*- texinfo -*-
## @deftypefn {} {@var{D} =} difference_quotients (@var{f}, @var{steps})
## The derivatives at 0 of a function @var{f}, which takes k arguments (n-by-k) at once, by its n numbers (m-by-n):
## central differences of the fourth order with the @var{steps} (n-by-1), exact for what is cubic.  Without numbers
## there is nothing to ask: 0-by-0.
## @end deftypefn

function D = difference_quotients (f, steps)
  D = zeros (0, 0);
  if (isempty (steps))
    return;
  endif
  along = diag (steps);
  values = f ([along, -along, 2*along, -2*along]);
  values = mat2cell (values, rows (values), numel (steps)*ones (1, 4));
  D = (8*(values{1} - values{2}) - (values{3} - values{4}))./(12*steps(:).');
endfunction

%!assert (difference_quotients (@(x) error ("asked"), zeros (0, 1)), zeros (0, 0))
%!assert (difference_quotients (@(x) [x(1,:).^3 + 2*x(1,:); x(2,:).*x(1,:) - x(2,:)], [0.1; 0.2]), [2 0; 0 -1], 1e-13)
