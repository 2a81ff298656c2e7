## -*- texinfo -*-
## @deftypefn {} {@var{model} =} build_model (@var{scene})
## The model of a checked scene's rod: modes ([N1 N2]), reason (why these), section, arrays (@code{rod_arrays}) and the
## slopes of the base functions at O.
## @end deftypefn

function model = build_model (scene)
  [model.modes, model.reason] = choose_modes (scene.model);
  model.length = scene.rod.length;
  model.section = rod_section (scene.rod, scene.model);
  model.arrays = rod_arrays (model.modes, model.length, model.section);
  [model.slope_1, model.slope_2] = rod_slopes (model.modes, 0, model.length);
endfunction

function [modes, reason] = choose_modes (choice)
  [modes, reason] = deal (choice.modes, "given by the scene");
  if (ischar (modes))
    [modes, reason] = deal ([7 7], "the paper's numbers of modes, where the scene gives none");
  endif
  modes = double (modes(:).');
  if (strcmp (choice.axial, "none"))
    modes(1) = 0;
  endif
endfunction

%!test
%! model = build_model (check_scene (paper ()));
%! assert (model.modes, [7 7]);
%! assert (numel (model.slope_1), 14);
