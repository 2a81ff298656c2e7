## -*- texinfo -*-
## @deftypefn {} {@var{section} =} rod_section (@var{rod}, @var{choice})
## The section's mass, rotary inertia and stiffnesses per unit of length: fields rhoA (kg/m), rhoI (kg m), EA (N),
## EI (N m^2) and GI (N m^2, against the gradient of the axial strain).
##
## @var{rod} and @var{choice} are the fields @code{rod} and @code{model} of a checked scene.
## @end deftypefn

function section = rod_section (rod, choice)
  if (isempty (rod.EA))
    [rhoA, rhoI] = section_inertia (rod.width, rod.half_height, rod.density);
    stiffness = @section_stiffness_uniaxial;
    if (strcmp (choice.energy, "paper"))
      stiffness = @section_stiffness_paper;
    endif
    [EA, EI, GI] = stiffness (rod.width, rod.half_height, rod.lambda, rod.mu);
  else
    rhoA = rod.rhoA;
    rhoI = rod.rhoI;
    EA = rod.EA;
    EI = rod.EI;
    GI = 0;
  endif
  if (isempty (rhoI))
    rhoI = 0;
  endif
  section = struct ("rhoA", rhoA, "rhoI", rhoI*choice.rotary_inertia, "EA", EA, "EI", EI, "GI", GI);
endfunction

%!test # a steel bar: E I of the classical rod
%! rod = struct ("width", 0.02, "half_height", 0.015, "lambda", 1.2e11, "mu", 8e10, "density", 7800, "EA", []);
%! section = rod_section (rod, struct ("energy", "uniaxial", "rotary_inertia", true));
%! assert (section.EI, 208e9*0.02*0.03^3/12, 1e-9*section.EI);
%! assert (section.EA, 208e9*0.02*0.03, 1e-9*section.EA);
%! assert (section.rhoA, 7800*0.02*0.03, 1e-12);
%! section = rod_section (rod, struct ("energy", "paper", "rotary_inertia", false));
%! assert (section.EI, 280e9*0.02*0.03^3/12, 1e-9*section.EI);
%! assert (section.rhoI, 0);

%!test # stiffnesses and masses given instead
%! rod = struct ("EA", 2.8e7, "EI", 1.4e4, "rhoA", 1.2, "rhoI", []);
%! section = rod_section (rod, struct ("energy", "paper", "rotary_inertia", true));
%! assert ([section.EA, section.EI, section.GI, section.rhoA, section.rhoI], [2.8e7, 1.4e4, 0, 1.2, 0]);
