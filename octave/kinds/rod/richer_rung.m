## -*- texinfo -*-
## @deftypefn {} {@var{rung} =} richer_rung (@var{rung}, @var{scene})
## A rung that has more of everything that the @var{scene} does not fix: twice as many modes and two more, up to 30 of
## a kind; the next treatment of the longitudinal modes; foreshortening.
## @end deftypefn

function rung = richer_rung (rung, scene)
  more = @(n) min (2*n + 2, 30);
  rung.bending = more (rung.bending);
  if (strcmp (rung.axial, "dynamic"))
    rung.longitudinal = more (rung.longitudinal);
  elseif (strcmp (scene.model.axial, "auto"))
    names = axial_treatments (scene);
    rung.axial = names{find(strcmp (names, rung.axial)) + 1};
    rung.longitudinal = 3*strcmp (rung.axial, "dynamic");
  endif
  if (strcmp (scene.model.stiffening, "auto"))
    rung.stiffening = "foreshortening";
  endif
endfunction

%!test
%! scene = check_scene (paper ());
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! rung = richer_rung (rigid, scene);
%! assert ({rung.bending, rung.axial, rung.stiffening}, {2, "quasistatic", "foreshortening"});
%! rung = richer_rung (rung, scene);
%! assert ({rung.bending, rung.axial, rung.longitudinal}, {6, "dynamic", 3});
