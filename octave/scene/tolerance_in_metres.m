## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} tolerance_in_metres (@var{tolerance}, @var{pixel})
## A scene's @var{tolerance} as a length: "pixel" is half a @var{pixel} (m) of a drawn frame.
## @end deftypefn

function metres = tolerance_in_metres (tolerance, pixel)
  metres = tolerance;
  if (ischar (tolerance))
    metres = pixel/2;
  endif
endfunction

%!assert (tolerance_in_metres ("pixel", 4e-3), 2e-3)
%!assert (tolerance_in_metres (1e-6, 4e-3), 1e-6)
