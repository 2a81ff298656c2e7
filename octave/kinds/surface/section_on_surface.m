## -*- texinfo -*-
## @deftypefn {} {@var{rod} =} section_on_surface (@var{rod}, @var{strain})
## The @var{rod} of a scene on a surface with the stiffnesses and inertia of its section: stated, or those of a
## rectangle of a material (see @code{surface_scene_fields}), whose normal stresses work along the rod alone; and with
## engineering, whether its axial @var{strain} is "engineering" (1) or "Green" (0; see maxima/surface/rod.mac).
## @end deftypefn

function rod = section_on_surface (rod, strain = "Green")
  check_section (rod);
  if (isempty (rod.EA))
    section = rod_section (rod, struct ("energy", "uniaxial", "rotary_inertia", true));
    [~, across] = section_stiffness_uniaxial (2*rod.half_height, rod.width/2, rod.lambda, rod.mu);
    sides = sort ([rod.width, 2*rod.half_height], "descend");
    default = {"EI_normal", across; "GJ", section_torsion(sides(1), sides(2), rod.mu); "rhoI", section.rhoI};
    [rod.EA, rod.EI, rod.rhoA] = deal (section.EA, section.EI, section.rhoA);
  else
    default = {"EI_normal", rod.EI; "GJ", 0; "rhoI", 0};
  endif
  for row = default.'
    if (isempty (rod.(row{1})))
      rod.(row{1}) = row{2};
    endif
  endfor
  if (isempty (rod.half_height))
    rod.half_height = rod.length/200;
  endif
  rod.engineering = double (strcmp (strain, "engineering"));
endfunction

%!function rod = with (varargin)
%!  rod = struct ("length", 1, "width", [], "half_height", [], "lambda", 1.2e11, "mu", 8.1e10, "density", 7800, ...
%!                "EA", [], "EI", [], "EI_normal", [], "GJ", [], "rhoA", [], "rhoI", []);
%!  for pair = reshape (varargin, 2, [])
%!    rod = setfield (rod, pair{:});
%!  endfor
%!endfunction

%!test # a square, whose torsion is 0.1406 G a^4 (Timoshenko and Goodier, art. 109), and a strip, 0.312 of a b^3
%! rod = section_on_surface (with ("width", 0.02, "half_height", 0.01));
%! E = 8.1e10*(3*1.2e11 + 2*8.1e10)/(1.2e11 + 8.1e10);
%! assert ([rod.EA, rod.EI, rod.EI_normal], E*[0.02^2, 0.02^4/12, 0.02^4/12], -1e-12);
%! assert (rod.GJ, 0.1406*8.1e10*0.02^4, -3e-4); assert (rod.rhoI, 7800*0.02^4/12, -1e-12);
%! rod = section_on_surface (with ("width", 0.002, "half_height", 0.01));
%! assert (rod.GJ, 0.312*8.1e10*0.02*0.002^3, -2e-3);
%! assert (rod.EI_normal/rod.EI, 0.01, -1e-12);
%!test # what is stated
%! rod = section_on_surface (with ("EA", 1, "EI", 2, "rhoA", 3));
%! assert ([rod.EI_normal, rod.GJ, rod.rhoI, rod.half_height], [2 0 0 1/200]);
%! assert (section_on_surface (with ("EA", 1, "EI", 2, "rhoA", 3, "GJ", 4)).GJ, 4);
%! assert (section_on_surface (with ("EA", 1, "EI", 2, "rhoA", 3), "engineering").engineering, 1);
%! assert (section_on_surface (with ("EA", 1, "EI", 2, "rhoA", 3), "Green").engineering, 0);
%!error <rod.width and rod.half_height are missing> section_on_surface (with ())
