## -*- texinfo -*-
## @deftypefn {} {@var{rung} =} rung_of_scene (@var{scene})
## The rung of the ladder of models that a checked scene states by model.modes = [N1 N2]: the paper's sines.
##
## A rung is a struct: sines ([N1 N2], or empty for eigenmodes), bending and longitudinal (how many eigenmodes), axial
## ("none", "quasistatic", "dynamic") and stiffening ("none", "foreshortening").
## @end deftypefn

function rung = rung_of_scene (scene)
  choice = scene.model;
  sines = double (choice.modes(:).');
  if (strcmp (choice.axial, "none"))
    sines(1) = 0;
  endif
  axial = choice.axial;
  if (sines(1) == 0)
    axial = "none";
  elseif (strcmp (axial, "auto"))
    axial = "dynamic";
  endif
  stiffening = strrep (choice.stiffening, "auto", "none");
  rung = struct ("sines", sines, "bending", sines(2), "longitudinal", sines(1), "axial", axial, ...
                 "stiffening", stiffening);
endfunction

%!test
%! scene = check_scene (setfield (paper (), "model", "modes", [7 7]));
%! assert (rung_of_scene (scene).axial, "dynamic");
%! scene.model.axial = "none";
%! assert (rung_of_scene (scene).sines, [0 7]);
