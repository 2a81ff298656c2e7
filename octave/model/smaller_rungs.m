## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} smaller_rungs (@var{rung}, @var{scene})
## The rungs right below one, as a cell array: without foreshortening, with the simpler treatment of the longitudinal modes
## or one of them less, with one bending mode less; what the @var{scene} fixes stays.
## @end deftypefn

function rungs = smaller_rungs (rung, scene)
  rungs = {};
  if (strcmp (rung.stiffening, "foreshortening") && strcmp (scene.model.stiffening, "auto"))
    rungs{end+1} = setfield (rung, "stiffening", "none");
  endif
  if (strcmp (rung.axial, "dynamic") && rung.longitudinal > 1)
    rungs{end+1} = setfield (rung, "longitudinal", rung.longitudinal - 1);
  elseif (! strcmp (rung.axial, "none") && strcmp (scene.model.axial, "auto"))
    before = struct ("dynamic", "quasistatic", "quasistatic", "none");
    rungs{end+1} = setfield (setfield (rung, "axial", before.(rung.axial)), "longitudinal", 0);
  endif
  if (rung.bending > 0)
    rungs{end+1} = setfield (rung, "bending", rung.bending - 1);
  endif
endfunction

%!test
%! scene = check_scene (paper ());
%! rung = struct ("sines", [], "bending", 2, "longitudinal", 1, "axial", "dynamic", "stiffening", "foreshortening");
%! names = cellfun (@rung_name, smaller_rungs (rung, scene), "uniformoutput", false);
%! assert (names, {"2 bending + 1 longitudinal modes", "2 bending modes, quasi-static longitudinal ones, foreshortening", ...
%!                 "1 bending + 1 longitudinal modes, foreshortening"});
