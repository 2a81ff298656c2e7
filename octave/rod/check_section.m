## -*- texinfo -*-
## @deftypefn {} {} check_section (@var{rod}, @var{prefix})
## An error where a rod's section is stated by halves; @var{prefix} ("" or "bodies(2).") says whose it is.
## @end deftypefn

function check_section (rod, prefix = "")
  own = ! cellfun (@isempty, {rod.EA, rod.EI, rod.rhoA});
  if (any (own) && ! all (own))
    scene_error ("%srod.EA, rod.EI and rod.rhoA are given together or not at all", prefix);
  elseif (! any (own) && (isempty (rod.width) || isempty (rod.half_height)))
    scene_error ("%srod.width and rod.half_height are missing: they take positive numbers in m", prefix);
  endif
endfunction

%!error <bodies\(2\).rod.EA, rod.EI and rod.rhoA are given together>
%! check_section (struct ("EA", 1, "EI", [], "rhoA", []), "bodies(2).")
%!error <^rod.width and rod.half_height are missing: they take positive numbers in m>
%! check_section (struct ("EA", [], "EI", [], "rhoA", [], "width", 1, "half_height", []))
%!error <^rod.width and rod.half_height are missing>
%! check_section (struct ("EA", [], "EI", [], "rhoA", [], "width", [], "half_height", 1))
%!test # a section's own stiffnesses, or its sides
%! check_section (struct ("EA", 1, "EI", 1, "rhoA", 1, "width", [], "half_height", []));
%! check_section (struct ("EA", [], "EI", [], "rhoA", [], "width", 1, "half_height", 1));
