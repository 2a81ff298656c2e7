## -*- texinfo -*-
## @deftypefn {} {@var{name} =} rung_name (@var{rung})
## A rung of the ladder in words: "3 bending + 2 longitudinal modes, foreshortening", "7 + 7 sines", "rigid".
## @end deftypefn

function name = rung_name (rung)
  if (! isempty (rung.sines) && any (rung.sines))
    name = sprintf ("%d + %d sines", rung.sines);
  elseif (rung.bending == 0 && strcmp (rung.axial, "none"))
    name = "rigid";
  elseif (strcmp (rung.axial, "dynamic"))
    name = sprintf ("%d bending + %d longitudinal modes", rung.bending, rung.longitudinal);
  elseif (rung.bending == 1)
    name = "1 bending mode";
  else
    name = sprintf ("%d bending modes", rung.bending);
  endif
  if (strcmp (rung.axial, "quasistatic"))
    name = [name ", quasi-static longitudinal ones"];
  endif
  if (strcmp (rung.stiffening, "foreshortening"))
    name = [name ", foreshortening"];
  endif
endfunction

%!assert (rung_name (struct ("sines", [7 7], "axial", "dynamic", "stiffening", "none")), "7 + 7 sines")
%!assert (rung_name (struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", ...
%!                           "stiffening", "none")), "rigid")
%!test
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 0, ...
%!               "axial", "quasistatic", "stiffening", "foreshortening");
%! assert (rung_name (rung), "1 bending mode, quasi-static longitudinal ones, foreshortening");
