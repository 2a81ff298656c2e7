## -*- texinfo -*-
## @deftypefn {} {@var{ratio} =} curved_thickness (@var{rod}, @var{section})
## How thick a @var{rod} (a checked scene's field) is against the radius of its curvature: the square of the radius of
## gyration of its @var{section} (see @code{rod_section}) over that of the smallest radius.  By about so much its stiffness
## is not that of EA and EI: layers inside of the axis are shorter than those outside.  A straight one has 0.
## @end deftypefn

function ratio = curved_thickness (rod, section)
  ratio = 0;
  if (! isempty (rod.curvature))
    kappa = norm (rod_axis (rod, 16).kappa, Inf);
    ratio = kappa^2*section.EI/section.EA;
  endif
endfunction

%!test
%! rod = struct ("length", 1, "curvature", [2 -5], "curvature_breaks", []);
%! section = struct ("EA", 100, "EI", 1);
%! assert (curved_thickness (rod, section), 9*0.01, 1e-3);
%! assert (curved_thickness (setfield (rod, "curvature", []), section), 0);
