## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{names}, @var{driven}] =} unit_inputs (@var{scene}, @var{t})
## A checked @var{scene} whose time is the number of an input: at 0 its loads and what its joints prescribe are those
## of the time @var{t} (s), at the time k the k-th of them is larger by one. @var{names} (cellstr, with units) are
## those of the inputs: each component of each force and moment, then of each prescribed place and angle; @var{driven}
## (1 by as many) says which are prescribed.
## @end deftypefn

function [scene, names, driven] = unit_inputs (scene, t)
  names = {};
  driven = logical ([]);
  units = struct ("moment", "N m", "tip_moment", "N m", "force", "N", "angle", "rad", "position", "m");
  [~, own_loads] = acting_loads (scene);
  for name = own_loads
    now = at_times (scene.(name{1}), t);
    scene.(name{1}) = unit_by_number (now, numel (names));
    names = [names, component_names(name{1}, numel (now), units.(name{1}))];
  endfor
  driven(1:numel (names)) = false;
  if (isfield (scene, "joints"))
    loads = is_load (scene.joints);
    prescribed = ismember ({scene.joints.kind}, {"angle", "position"})(:).';
    for k = [find(loads), find(prescribed)]
      joint = scene.joints(k);
      now = joint.value (t);
      scene.joints(k).value = unit_by_number (now, numel (names));
      own = component_names (joint.name, columns (now), units.(joint.kind));
      names = [names, own];
      driven = [driven, repmat(prescribed(k), 1, numel (own))];
    endfor
    for k = find (! (loads | prescribed))
      now = scene.joints(k).value (t);
      scene.joints(k).value = @(number) repmat (now, 1, numel (number));
    endfor
  endif
endfunction

## of numbers in a column, or a row with rates below
function value = unit_by_number (now, before)
  one = @(number) (1:columns (now)) == number - before;
  larger = @(number) now + [one(number); zeros(rows (now) - 1, columns (now))];
  if (columns (now) == 1 && rows (now) > 1)
    larger = @(number) now + ((1:rows (now)).' == number - before);
  endif
  value = @(numbers) [arrayfun(larger, numbers, "uniformoutput", false){:}];
endfunction

function names = component_names (name, count, unit)
  names = {sprintf("%s [%s]", name, unit)};
  if (count > 1)
    names = cellfun (@(axis) sprintf ("%s_%s [%s]", name, axis, unit), {"x", "y", "z"}(1:count), ...
                     "uniformoutput", false);
  endif
endfunction

%!test # a force, and an angle with its rates
%! joints = struct ("name", {"pull", "drive"}, "kind", {"force", "angle"}, "value", {@(t) [t, 1], @(t) [t; 1; 0]});
%! [scene, names, driven] = unit_inputs (struct ("force", @(t) [t 2 3], "joints", joints), 5);
%! assert (names, {"force_x [N]", "force_y [N]", "force_z [N]", "pull_x [N]", "pull_y [N]", "drive [rad]"});
%! assert (driven, [false(1, 5), true]);
%! assert (scene.force (0), [5; 2; 3]); assert (scene.force (2), [5; 3; 3]); assert (scene.force (4), [5; 2; 3]);
%! assert (scene.joints(1).value (4), [6 1]); assert (scene.joints(1).value (5), [5 2]);
%! assert (scene.joints(2).value (6), [6; 1; 0]); assert (scene.joints(2).value (5), [5; 1; 0]);
