## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} too_thick (@var{rod}, @var{section})
## Whether a curved @var{rod} (a checked scene's field) is too thick for the geometrically exact one: layers inside of
## its axis are shorter than those outside, by which its stiffness is not that of EA and EI.  That is by about the
## square of the radius of gyration of its @var{section} (see @code{rod_section}) over that of the smallest radius, here
## above a thousandth.
## @end deftypefn

function yes = too_thick (rod, section)
  yes = false;
  if (! isempty (rod.curvature))
    yes = norm (rod_axis (rod, 16).kappa, Inf)^2*section.EI/section.EA > 1e-3;
  endif
endfunction

%!test # the largest curvature counts, be it to the right
%! rod = struct ("length", 1, "curvature", [2 -5], "curvature_breaks", []);
%! assert (too_thick (rod, struct ("EA", 8500, "EI", 1)), true);
%! assert (too_thick (rod, struct ("EA", 9500, "EI", 1)), false);
%! assert (too_thick (setfield (rod, "curvature", []), struct ("EA", 1, "EI", 1)), false);
