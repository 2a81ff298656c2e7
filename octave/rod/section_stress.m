## -*- texinfo -*-
## @deftypefn {} {@var{stress} =} section_stress (@var{rod}, @var{stations}, @var{forces})
## The largest stress (p-by-1, Pa) in the sections of a @var{rod}, straight or curved, at the @var{stations} (p-by-1,
## m) that bear @var{forces}, a struct of N (N) and M (N m; p-by-1): abs (N)/A + abs (M) h/I of a straight one; the
## inner side of a curved one bears more (see @code{curved_rod_stress}).  NaN where it does not follow from what the
## rod states (see @code{stress_unknown}).
## @end deftypefn

function stress = section_stress (rod, stations, forces)
  stress = NaN (size (forces.M));
  if (isempty (stress_unknown (rod)))
    [left, right] = curved_rod_stress (forces.N, forces.M, curvature_at (rod, stations), rod);
    stress = max (abs (left), abs (right));
  endif
endfunction

%!function rod = of_section (width, half_height, curvature = [])
%!  rod = struct ("width", width, "half_height", half_height, "EA", [], "curvature", curvature, "length", 1);
%!endfunction
%!test # 2 m by 6 m: A = 12, I/h = 12
%! forces = struct ("N", [-24; 0], "M", [12; -36]);
%! assert (section_stress (of_section (2, 3), [0; 1], forces), [3; 3], 1e-12);
%! assert (section_stress (of_section ([], 3), [0; 1], forces), [NaN; NaN]);
%!function [found, inner] = of_bar (h, R, side)   # Winkler's and Bach's; the neutral line is nearer to the centre
%!  neutral = 2*h/log ((R + h)/(R - h));
%!  inner = (neutral - (R - h))/(2*h*0.02*(R - neutral)*(R - h));  # of a moment of 1 N m
%!  found = section_stress (of_section (0.02, h, side/R), 0, struct ("N", 0, "M", -1));
%!endfunction
%!test # the stress at the inner side of a curved bar, to the second order of its height by its radius
%! for side = [1 -1]
%!   [found, inner] = of_bar (0.01, 0.1, side);
%!   assert (found, inner, 0.007*inner);
%!   assert (found > 1.07*3/(2*0.01^2*0.02));  # which is that of a straight bar, and 1.07 times
%!   [half, half_inner] = of_bar (0.005, 0.1, side);
%!   assert (half/half_inner - 1, (found/inner - 1)/4, 0.1*(found/inner - 1));
%! endfor
%!assert (section_stress (of_section (0.02, 0.01, 10), 0, struct ("N", 3, "M", 0)), 3/(4e-4), 1e-9);
