## -*- texinfo -*-
## @deftypefn {} {@var{rung} =} smaller_rung (@var{rung}, @var{part}, @var{scene})
## The rung below one in a @var{part}: "axial" (one longitudinal mode less, or the simpler treatment), "bending" (one
## mode less) or "stiffening" (none).  Where there is none, or the @var{scene} fixes the part, it is the same rung.
## @end deftypefn

function rung = smaller_rung (rung, part, scene)
  switch (part)
    case "stiffening"
      if (strcmp (scene.model.stiffening, "auto"))
        rung.stiffening = "none";
      endif
    case "bending"
      rung.bending = max (rung.bending - 1, 0);
    case "axial"
      if (strcmp (rung.axial, "dynamic") && rung.longitudinal > 1)
        rung.longitudinal--;
      elseif (strcmp (scene.model.axial, "auto"))
        names = axial_treatments (scene);
        rung.axial = names{max(find (strcmp (names, rung.axial)) - 1, 1)};
        rung.longitudinal = 0;
      endif
  endswitch
endfunction

%!test
%! scene = check_scene (paper ());
%! rung = struct ("sines", [], "bending", 2, "longitudinal", 1, "axial", "dynamic", "stiffening", "foreshortening");
%! name = @(part) rung_name (smaller_rung (rung, part, scene));
%! assert (name ("stiffening"), "2 bending + 1 longitudinal modes");
%! assert (name ("axial"), "2 bending modes, quasi-static longitudinal ones, foreshortening");
%! assert (name ("bending"), "1 bending + 1 longitudinal modes, foreshortening");
