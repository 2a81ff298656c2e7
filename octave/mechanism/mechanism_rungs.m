## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} mechanism_rungs (@var{scene}, @var{levels}, @var{longitudinal})
## The rungs of a checked scene's bodies (a cell each): the modes that a body states, or, where they are "auto", those
## of its @var{levels}: 0 is rigid, k has k bending modes; and so many @var{longitudinal} ones (see
## @code{longitudinal_modes}).
##
## Only "auto" takes corrections of the sines (see @code{base_functions}), at ends where a joint may bear a moment.
## @end deftypefn

function rungs = mechanism_rungs (scene, levels, longitudinal = longitudinal_modes (levels))
  rungs = {};
  for k = 1:numel (scene.bodies)
    choice = scene.bodies(k).model;
    if (ischar (choice.modes))
      level = levels(k);
      default_stiffening = {"foreshortening", "none"}{1 + ! isempty(scene.bodies(k).rod.curvature)};
      rung = struct ("sines", [longitudinal(k)*! strcmp(choice.axial, "none"), level], ...
                     "stiffening", strrep (choice.stiffening, "auto", default_stiffening));
      rung.corrections = clamped_ends (scene, k)(1:end*(level > 0));
    else
      rung = struct ("sines", double (choice.modes(:).'), "stiffening", strrep (choice.stiffening, "auto", "none"));
      rung.sines(1) *= ! strcmp (choice.axial, "none");
      rung.corrections = [];
    endif
    rung.bending = rung.sines(2) + numel (rung.corrections);
    rung.longitudinal = rung.sines(1);
    rung.axial = {"none", "dynamic"}{1 + (rung.sines(1) > 0)};
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

%!test # only chosen modes have corrections, at ends that bear moments
%! [~, ~, scene] = sample_mechanism ([1 2]);
%! scene.bodies(2).model.modes = "auto";
%! rungs = mechanism_rungs (scene, [0 3 0]);
%! assert (rungs{1}.sines, [1 2]); assert (rungs{2}.sines, [1 3]); assert (rungs{2}.corrections, -1);
