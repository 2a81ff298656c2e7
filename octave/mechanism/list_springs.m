## -*- texinfo -*-
## @deftypefn {} {[@var{springs}, @var{loads}] =} list_springs (@var{mechanism}, @var{joints})
## The springs of the @var{joints} (those of one function at once: form, first, second (markers), stiffness, damping,
## rest), and the loads (a struct array of value (function of t), parts (1, 2, 3: F_x, F_y, M), first, second).
## @end deftypefn

function [springs, loads] = list_springs (mechanism, joints)
  [springs, loads] = deal (struct ([]));
  if (isempty (joints))
    return;
  endif
  kinds = joint_kinds ();
  kind_of = arrayfun (@(joint) find (strcmp ({kinds.name}, joint.kind)), joints);
  for k = unique (kind_of(:)).'
    j = find (kind_of == k);
    markers = num2cell (mechanism.marker_of(j,:), 1);
    if (! isempty (kinds(k).springs))
      springs = [springs, struct("form", kinds(k).springs{1}, "first", markers{1}, "second", markers{2}, ...
                                 "stiffness", vertcat (joints(j).stiffness), "damping", vertcat (joints(j).damping), ...
                                 "rest", vertcat (joints(j).rest))];
    endif
    for i = reshape (j(1:end*! isempty (kinds(k).loads)), 1, [])
      loads = [loads, struct("value", joints(i).value, "parts", kinds(k).loads, ...
                             "first", mechanism.marker_of(i,1), "second", mechanism.marker_of(i,2))];
    endfor
  endfor
endfunction

%!test
%! mechanism = sample_mechanism ([0 1]).mechanism;
%! assert (numel (mechanism.springs), 2); assert (mechanism.loads.parts, [1 2]);
