## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} mechanism_rungs (@var{scene}, @var{levels}, @var{longitudinal})
## The rungs of a checked scene's bodies (a cell each): the modes that a body states, or, where they are "auto", those
## of its @var{levels}: 0 is rigid, k has k bending modes; and so many @var{longitudinal} ones (default: none).
##
## Only "auto" takes corrections of the sines (see @code{base_functions}): at ends where a joint may bear a moment,
## and, beside longitudinal modes, elongations where a joint may bear a force or a tip_mass hangs.
## @end deftypefn

function rungs = mechanism_rungs (scene, levels, longitudinal = 0*levels)
  rungs = {};
  for k = 1:numel (scene.bodies)
    if (ischar (scene.bodies(k).model.modes))
      rung = rung_of_level (scene, k, levels(k), longitudinal(k));
    else
      rung = stated_rung (scene.bodies(k).model);
    endif
    rung.bending = rung.sines(2) + numel (rung.corrections);
    rung.longitudinal = rung.sines(1) + numel (rung.elongations);
    rung.axial = "none";
    if (rung.longitudinal > 0)
      rung.axial = "dynamic";
    endif
    rungs{k} = rung;
  endfor
endfunction

function rung = stated_rung (choice)
  rung.sines = double (choice.modes(:).');
  if (strcmp (choice.axial, "none"))
    rung.sines(1) = 0;
  endif
  rung.stiffening = strrep (choice.stiffening, "auto", "none");
  rung.corrections = rung.elongations = [];
endfunction

function rung = rung_of_level (scene, k, level, longitudinal)
  body = scene.bodies(k);
  rung = struct ("sines", [longitudinal, level], "stiffening", body.model.stiffening);
  if (strcmp (body.model.axial, "none"))
    rung.sines(1) = 0;
  endif
  if (strcmp (rung.stiffening, "auto") && isempty (body.rod.curvature))
    rung.stiffening = "foreshortening";
  elseif (strcmp (rung.stiffening, "auto"))
    rung.stiffening = "none";
  endif
  rung.corrections = rung.elongations = zeros (1, 0);
  if (strcmp (rung.stiffening, "exact"))
    return;
  endif
  [pushed, turned] = stations_of_joints (scene.joints, k);
  if (level > 0)
    rung.corrections = moment_corrections (turned, body.rod.length);
  endif
  if (rung.sines(1) > 0)
    pushed = [pushed, body.rod.length(body.tip_mass > 0)];
    rung.elongations = elongation_numbers (pushed, body.rod, rod_section (body.rod, body.model));
  endif
endfunction

%!test # only chosen modes have corrections, at ends that bear moments
%! [~, ~, scene] = sample_mechanism ([1 2]);
%! scene.bodies(2).model.modes = "auto";
%! rungs = mechanism_rungs (scene, [0 3 0], [0 1 0]);
%! assert (rungs{1}.sines, [1 2]); assert (rungs{1}.elongations, []);
%! assert (rungs{2}.sines, [1 3]); assert (rungs{2}.corrections, -1);
%!test # a rod that pins and a load within it pull, and one that hangs at its O alone
%! body = struct ("rod", struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1));
%! scene.bodies = {body, body};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [1 0]), ...
%!                 struct("kind", "force", "bodies", 1, "stations", 0.5), ...
%!                 struct("kind", "moment", "bodies", 2, "stations", 1)};
%! scene.duration = 1;
%! scene.joints{3}.value = [0 0];
%! rungs = @(longitudinal) mechanism_rungs (check_mechanism (scene), [0 0], longitudinal);
%! assert (rungs ([3 1]){1}.elongations, [-1 -0.5]); assert (rungs ([3 1]){1}.longitudinal, 5);
%! assert (rungs ([3 1]){2}.elongations, zeros (1, 0)); assert (rungs ([3 1]){2}.sines, [1 0]);
%! assert (rungs ([0 1]){1}.elongations, zeros (1, 0)); assert (rungs ([0 1]){1}.axial, "none");
%!test # a body that states its modes and no stretching keeps the transversal ones
%! [~, ~, scene] = sample_mechanism ([1 2]);
%! scene.bodies(1).model.axial = "none";
%! assert (mechanism_rungs (scene, [0 0 0]){1}.sines, [0 2]);
