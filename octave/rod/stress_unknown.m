## -*- texinfo -*-
## @deftypefn {} {@var{reason} =} stress_unknown (@var{rod})
## Why the stress in a @var{rod} does not follow from what its fields state; "" where it does: with a width and a
## height it is a rectangle of one material, unless stiffnesses are stated that no such rectangle has.
## @end deftypefn

function reason = stress_unknown (rod)
  reason = "";
  if (isempty (rod.half_height) || isempty (rod.width))
    reason = "rod.width and rod.half_height are not both stated";
  elseif (! isempty (rod.EA))
    [A, I] = section_inertia (rod.width, rod.half_height, 1);
    if (abs (rod.EI/rod.EA - I/A) > 0.01*I/A)
      reason = sprintf (["rod.EI/rod.EA is %.3g m^2, and %.3g m^2 where a section of rod.width by 2" ...
                         " rod.half_height is of one material"], rod.EI/rod.EA, I/A);
    endif
  endif
endfunction

%!assert (stress_unknown (struct ("width", 0.02, "half_height", 0.01, "EA", [], "EI", [])), "")
%!assert (stress_unknown (struct ("width", 3, "half_height", 0.5, "EA", 36, "EI", 3)), "")
%!assert (stress_unknown (struct ("width", [], "half_height", 1, "EA", 1, "EI", 1)), ...
%!        "rod.width and rod.half_height are not both stated")
%!assert (stress_unknown (struct ("width", 3, "half_height", 0.5, "EA", 36, "EI", 3.1)), ...
%!        ["rod.EI/rod.EA is 0.0861 m^2, and 0.0833 m^2 where a section of rod.width by 2 rod.half_height is of" ...
%!         " one material"])
