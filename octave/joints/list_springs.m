## -*- texinfo -*-
## @deftypefn {} {[@var{springs}, @var{loads}] =} list_springs (@var{mechanism}, @var{joints})
## The springs of the @var{joints}, a struct as of @code{list_constraints} (of their elongations) with stiffness and
## damping (a row an elongation), and the loads (a struct array of value (function of t), parts (1, 2, 3: F_x, F_y, M),
## first, second (markers)).
## @end deftypefn

function [springs, loads] = list_springs (mechanism, joints)
  for j = 1:numel (joints)
    if (! isempty (joint_kind (joints(j).kind).springs))
      joints(j).value = @(t) joints(j).rest*ones (1, 2*numel (t));
      joints(j).constant = true;
    endif
  endfor
  springs = list_constraints (mechanism, joints, "springs");
  springs.stiffness = vertcat (zeros (0, 1), joints(springs.joint).stiffness);
  springs.damping = vertcat (zeros (0, 1), joints(springs.joint).damping);
  loads = struct ([]);
  for j = find (is_load (joints))
    loads = [loads, struct("value", joints(j).value, "parts", joint_kind (joints(j).kind).loads, ...
                           "first", mechanism.marker_of(j,1), "second", mechanism.marker_of(j,2))];
  endfor
endfunction

%!test
%! mechanism = sample_mechanism ([0 1]).mechanism;
%! assert (mechanism.springs.stiffness, [2; 5]); assert (mechanism.loads.parts, [1 2]);
%!test # a bushing has two elongations
%! [~, ~, scene] = sample_mechanism ([0 1]);
%! joint = setfield (setfield (scene.joints(4), "kind", "bushing"), "rest", 0);
%! assert (list_springs (struct ("marker_of", [1 2], "marker_count", 2), joint).count, 2);
%! [springs, loads] = list_springs (struct ("marker_of", zeros (0, 2), "marker_count", 0), joint([]));
%! assert ({springs.stiffness, springs.damping, loads}, {zeros(0, 1), zeros(0, 1), struct([])});
