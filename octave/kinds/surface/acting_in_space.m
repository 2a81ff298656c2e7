## -*- texinfo -*-
## @deftypefn {} {[@var{springs}, @var{forces}] =} acting_in_space (@var{scene}, @var{history})
## The springs and the forces of a checked scene of a rod on a surface in its @var{history} (see
## @code{measure_surface}): structs of x, y, z (m, rows of one each, a column a time) where they act on the rod, and of
## to_x, to_y, to_z (m), where a spring's other end is, or F_x, F_y, F_z (N).
## @end deftypefn

function [springs, forces] = acting_in_space (scene, history)
  kinds = {scene.joints.kind};
  held = scene.joints(strcmp (kinds, "spring"));
  point = vertcat (zeros (0, 3), held.point);
  springs = places (scene, history, [held.stations]);
  for axis = 1:3
    springs.(["to_" "xyz"(axis)]) = repmat (point(:,axis), 1, numel (history.t));
  endfor

  pulling = scene.joints(strcmp (kinds, "force"));
  values = [{scene.force}, {pulling.value}];
  values = cellfun (@(value) at_times (value, history.t), values, "uniformoutput", false);
  acts = cellfun (@(value) any (value(:)), values);
  forces = places (scene, history, [scene.force_station, pulling.stations](acts));
  values = reshape (vertcat (zeros (0, numel (history.t)), values{acts}), 3, [], numel (history.t));
  for axis = 1:3
    forces.(["F_" "xyz"(axis)]) = reshape (values(axis,:,:), [], numel (history.t));
  endfor
endfunction

## of the rod, between those that its history has
function at = places (scene, history, stations)
  along = linspace (0, scene.rod.length, rows (history.x));
  for axis = "xyz"
    at.(axis) = zeros (0, numel (history.t));
    if (! isempty (stations))
      at.(axis) = reshape (interp1 (along, history.(axis), stations(:), "spline"), [], numel (history.t));
    endif
  endfor
endfunction

%!function [springs, forces] = of_line (joints, varargin)   # of 2 m along x, and 1 m higher at the second time
%!  scene.surface = struct ("name", "plane", "inclination", 0);
%!  scene.rod = struct ("length", 2, "EA", 1e7, "EI", 1, "rhoA", 1);
%!  [scene.joints, scene.duration] = deal (joints, 1);
%!  x = linspace (0, 2, 11).';
%!  history = struct ("t", [0 1], "x", [x x], "y", [3*x, 0*x], "z", [0*x, 0*x + 1]);
%!  [springs, forces] = acting_in_space (check_surface_scene (setfield (scene, varargin{:})), history);
%!endfunction
%!test
%! spring = struct ("kind", "spring", "bodies", 1, "stations", 0.5, "point", [7 8 9], "stiffness", 1);
%! force = struct ("kind", "force", "bodies", 1, "stations", 1, "value", @(t) [1, 2, 3*t]);
%! [springs, forces] = of_line ({spring, force}, "force", [0 5 0]);
%! assert ([springs.x, springs.y, springs.z], [0.5 0.5 1.5 0 0 1], 1e-12);
%! assert ([springs.to_x; springs.to_y; springs.to_z], [7 7; 8 8; 9 9]);
%! assert (forces.x, [2 2; 1 1], 1e-12); assert (forces.z, [0 1; 0 1], 1e-12);
%! assert (forces.F_y, [5 5; 2 2]); assert (forces.F_z, [0 0; 0 3]);
%!test # nothing acts
%! [springs, forces] = of_line ({}, "force", [0 0 0]);
%! assert (size (springs.to_x), [0 2]); assert (size (forces.F_z), [0 2]);
