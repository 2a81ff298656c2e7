## -*- texinfo -*-
## @deftypefn {} {@var{rung} =} curved_rung (@var{numbers})
## A rung of a curved rod's ladder (see @code{rung_of_scene}): @var{numbers} = [N1 N2] of longitudinal and bending base
## functions.
## @end deftypefn

function rung = curved_rung (numbers)
  axial = "none";
  if (numbers(1) > 0)
    axial = "dynamic";
  endif
  rung = struct ("sines", numbers, "bending", numbers(2), "longitudinal", numbers(1), "axial", axial, ...
                 "stiffening", "none");
endfunction

%!assert (curved_rung ([0 2]).axial, "none")
%!assert (curved_rung ([1 2]).longitudinal, 1)
