## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} mechanism_panels (@var{scene}, @var{history}, @var{names})
## Panels (see @code{new_panel}) of a mechanism's history, those with the @var{names}: "angles", "tips",
## "reactions" (sizes of the joints' forces), "energies" (with their balance); all by default.  Of more than six curves
## there are the first and the last three, and their label says of how many.
## @end deftypefn

function panels = mechanism_panels (scene, history, names = {"angles", "tips", "reactions", "energies"})
  bodies = history.bodies;
  [shown, of_bodies, some] = few ({scene.bodies.name});
  [forces, joints] = reaction_sizes (scene.joints, history);
  [shown_joints, of_joints, some_joints] = few (joints);
  all = {
    "angles",    @() new_panel (["angles" some], "°", of_bodies, rad2deg (vertcat (bodies(shown).phi)))
    "tips",      @() new_panel (["tips, height" some], "m", of_bodies, vertcat (bodies(shown).tip_y))
    "reactions", @() new_panel (["reactions" some_joints], "N", of_joints, forces(shown_joints,:))
    "energies",  @() energy_panels (history)
  };
  panels = struct ([]);
  for name = names
    if (! (strcmp (name{1}, "reactions") && isempty (joints)))
      panels = [panels, all{strcmp (all(:,1), name{1}),2}()];
    endif
  endfor
endfunction

function [shown, names, some] = few (names)
  shown = 1:numel (names);
  some = "";
  if (numel (names) > 6)
    some = sprintf (" (6 of %d)", numel (names));
    shown = [1:3, numel(names)-2:numel(names)];
  endif
  names = names(shown);
endfunction

## of joints that hold a point
function [forces, names] = reaction_sizes (joints, history)
  holds = @(joint) any (strcmp (joint_kind (joint.kind).sees, "point"));
  shown = find (! is_load (joints) & arrayfun (holds, joints(:).'));
  forces = zeros (numel (shown), numel (history.t));
  for k = 1:numel (shown)
    of_joint = history.joints(shown(k));
    forces(k,:) = hypot (of_joint.reaction_x, of_joint.reaction_y);
  endfor
  names = {joints(shown).name};
endfunction

%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, 0, start);
%! panels = mechanism_panels (scene, history, {"angles", "reactions"});
%! assert (size (panels(1).values), [3 1]); assert (panels(2).names, {"joint 1", "joint 2", "joint 3", "joint 5"});
%! assert ({panels.label}, {"angles", "reactions"});
%!test # of many bodies some, which is said
%! run = driver (setfield (chain (8), "duration", 0.02), "output", "");
%! panels = mechanism_panels (run.scene, run.history);
%! assert ({panels(1:3).label}, {"angles (6 of 8)", "tips, height (6 of 8)", "reactions (6 of 8)"});
%! assert (rows (panels(1).values), 6);
