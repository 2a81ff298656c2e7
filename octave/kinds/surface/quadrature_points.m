## -*- texinfo -*-
## @deftypefn {} {@var{n} =} quadrature_points (@var{model})
## The number of Gauss points along a rod on a surface with so many base functions (see @code{rod_functions}).
## @end deftypefn

function n = quadrature_points (model)
  n = 2*max (model.modes) + 4*max (model.sines) + 6;
endfunction

%!assert (quadrature_points (struct ("modes", [4 5], "sines", [0 0])), 16)
