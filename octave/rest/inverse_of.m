## -*- texinfo -*-
## @deftypefn {} {@var{inverse} =} inverse_of (@var{jacobian})
## The pseudoinverse of the @var{jacobian} of constraints, also where there are none, of which @code{pinv} gets the
## sizes wrong.
## @end deftypefn

function inverse = inverse_of (jacobian)
  inverse = zeros (columns (jacobian), rows (jacobian));
  if (! isempty (jacobian))
    inverse = pinv (jacobian);
  endif
endfunction

%!assert (inverse_of ([2 0; 0 4; 0 0]), [0.5 0 0; 0 0.25 0], 1e-15)
%!assert (inverse_of (zeros (0, 3)), zeros (3, 0))
