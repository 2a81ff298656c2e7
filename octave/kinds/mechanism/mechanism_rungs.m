## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} mechanism_rungs (@var{scene}, @var{levels}, @var{longitudinal})
## The rungs of a checked scene's bodies (a cell each): the modes that a body states, or, where they are "auto", those
## of its @var{levels}: 0 is rigid, k has k bending modes; and so many @var{longitudinal} ones (see
## @code{longitudinal_modes}).
##
## Only "auto" takes corrections of the sines (see @code{base_functions}): at ends where a joint may bear a moment, and,
## beside longitudinal modes, elongations where a joint may bear a force or a tip_mass hangs.
## @end deftypefn

function rungs = mechanism_rungs (scene, levels, longitudinal = longitudinal_modes (levels))
  rungs = {};
  for k = 1:numel (scene.bodies)
    choice = scene.bodies(k).model;
    if (ischar (choice.modes))
      level = levels(k);
      default_stiffening = {"foreshortening", "none"}{1 + ! isempty(scene.bodies(k).rod.curvature)};
      along = longitudinal(k)*! strcmp (choice.axial, "none");
      rung = struct ("sines", [along, level], "stiffening", strrep (choice.stiffening, "auto", default_stiffening));
      rung.corrections = clamped_ends (scene, k)(1:end*(level > 0));
      rung.elongations = elongations (scene, k)(1:end*(along > 0));
    else
      rung = struct ("sines", double (choice.modes(:).'), "stiffening", strrep (choice.stiffening, "auto", "none"));
      rung.sines(1) *= ! strcmp (choice.axial, "none");
      rung.corrections = rung.elongations = [];
    endif
    rung.bending = rung.sines(2) + numel (rung.corrections);
    rung.longitudinal = rung.sines(1) + numel (rung.elongations);
    rung.axial = {"none", "dynamic"}{1 + (rung.longitudinal > 0)};
    rungs{k} = rung;
  endfor
endfunction

## -1: O, -2: the tip
function corrections = clamped_ends (scene, k)
  corrections = [];
  for joint = scene.joints(:).'
    if (any (strcmp (joint.kind, {"weld", "angle", "torsion_spring", "moment"})))
      stations = joint.stations(joint.bodies == k);
      corrections = [corrections, repmat(-1, 1, any (stations == 0)), ...
                     repmat(-2, 1, any (stations == scene.bodies(k).rod.length))];
    endif
  endfor
  corrections = fliplr (unique (corrections));
endfunction

## numbers of the elongations by forces on the body's stations
function numbers = elongations (scene, k)
  body = scene.bodies(k);
  stations = body.rod.length(1:double (body.tip_mass > 0));
  for joint = scene.joints(:).'
    if (! any (strcmp (joint.kind, {"angle", "torsion_spring", "moment"})))
      stations = [stations, joint.stations(joint.bodies == k)];
    endif
  endfor
  numbers = elongation_numbers (stations, body.rod, rod_section (body.rod, body.model));
endfunction

%!test # only chosen modes have corrections, at ends that bear moments
%! [~, ~, scene] = sample_mechanism ([1 2]);
%! scene.bodies(2).model.modes = "auto";
%! rungs = mechanism_rungs (scene, [0 3 0]);
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
