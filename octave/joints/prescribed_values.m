## -*- texinfo -*-
## @deftypefn {} {@var{values} =} prescribed_values (@var{constraints}, @var{t})
## What the @var{constraints} (see @code{list_constraints}) prescribe at the times @var{t} (1-by-k): a cell a kind of
## them, a struct of value, value_dot, value_ddot (rows-by-k).
## @end deftypefn

function values = prescribed_values (constraints, t)
  values = cell (1, numel (constraints.kinds));
  every = ones (1, numel (t));
  asked = 1:numel (t);
  if (numel (t) > 1 && all (t == t(1)))  # one instant is asked for once
    t = t(1);
    asked = every;
  endif
  for i = 1:numel (constraints.kinds)
    kind = constraints.kinds(i);
    still = zeros (numel (kind.constant), numel (every));
    orders = {kind.constant*every, still, still};
    for j = moving_joints (kind)
      mine = find (kind.joints == j);
      value = reshape (constraints.values{j} (t), 3, [], numel (t));
      for order = 1:3
        orders{order}(mine,:) = value(order,kind.component(mine),asked);
      endfor
    endfor
    values{i} = cell2struct (orders, {"value", "value_dot", "value_ddot"}, 2);
  endfor
endfunction

function joints = moving_joints (kind)
  joints = [];
  if (! isempty (kind.moving))
    joints = unique (kind.joints(kind.moving)).';
  endif
endfunction

%!test # a position that moves has two components in two kinds, beside a joint that stands
%! kind = @(component) struct ("joints", [1; 2], "moving", 2, "component", component*[1; 1], "constant", [7; 0]);
%! constraints = struct ("kinds", [kind(1), kind(2)]);
%! constraints.values = {@(t) error ("not asked"), watched_columns("place", @(t) [t, 2*t; 1, 2; 0, 0])};
%! values = prescribed_values (constraints, [0 3]);
%! assert (values{1}.value, [7 7; 0 3]); assert (values{2}.value, [7 7; 0 6]);
%! assert (values{2}.value_dot, [0 0; 2 2]); assert (values{1}.value_ddot, zeros (2));
%!test # of one instant what moves is asked once
%! kind = struct ("joints", 1, "moving", 1, "component", 1, "constant", 0);
%! values = prescribed_values (struct ("kinds", kind, "values", {{@(t) rand(3, 1)}}), [2 2]);
%! assert (values{1}.value_dot(1), values{1}.value_dot(2)); assert (size (values{1}.value), [1 2]);
%! kind = struct ("joints", [1; 1], "moving", 1, "component", [2; 1], "constant", [0; 0]);
%! values = prescribed_values (struct ("kinds", kind, "values", {{@(t) [t, 2*t; 1, 3; 0, 0]}}), [2 2]);
%! assert (values{1}.value, [4 4; 2 2]); assert (values{1}.value_dot, [3 3; 1 1]);
