## -*- texinfo -*-
## @deftypefn {} {@var{stress} =} section_stress (@var{rod}, @var{section}, @var{forces})
## The largest stress (p-by-1, Pa) in sections of a straight @var{rod} that bear @var{forces}, a struct of N (N) and M
## (N m; p-by-1): abs (N)/A + abs (M) h/I.  NaN of a curved rod, and where it does not follow from what the rod states
## (see @code{stress_unknown}).  @var{section} is of @code{rod_section}.
## @end deftypefn

function stress = section_stress (rod, section, forces)
  stress = NaN (size (forces.M));
  if (isempty (stress_unknown (rod)) && isempty (rod.curvature))
    A = section_inertia (rod.width, rod.half_height, 1);
    stress = abs (forces.N)/A + rod_bending_stress (forces.M/section.EI, rod.width, rod.half_height, section.EI);
  endif
endfunction

%!test # 2 m by 6 m: A = 12, I/h = 12
%! rod = struct ("width", 2, "half_height", 3, "EA", [], "curvature", []);
%! forces = struct ("N", [-24; 0], "M", [12; -36]);
%! assert (section_stress (rod, struct ("EI", 5), forces), [3; 3], 1e-12);
%! assert (section_stress (setfield (rod, "curvature", 1), struct ("EI", 5), forces), [NaN; NaN]);
%! assert (section_stress (setfield (rod, "width", []), struct ("EI", 5), forces), [NaN; NaN]);
