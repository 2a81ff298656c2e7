## -*- texinfo -*-
## @deftypefn {} {@var{constraints} =} list_constraints (@var{mechanism}, @var{joints}, @var{field})
## The scalar constraints of all @var{joints}, or, where @var{field} is "springs", the elongations of their springs: a
## struct of kinds (those of one function at once: form, convection, rows, first, second (markers), to_first, to_second
## (markers-by-rows: they sum what rows have onto these markers), offset (of angles), takes_offset (whether form takes
## it), joints, coordinates (see @code{constraint_coordinates}), component (of the joint's value), constant (values),
## moving (those of the rows whose value is a function of time)), values (the joints' functions of t), names and joint
## (a constraint each; the joint's number) and count.
## @end deftypefn

function constraints = list_constraints (mechanism, joints, field = "constraints")
  constraints = struct ("kinds", struct ([]), "names", {{}}, "count", 0, "joint", []);
  constraints.values = {};
  if (isempty (joints))
    return;
  endif
  constraints.values = {joints.value};
  table = {};
  for j = 1:numel (joints)
    forms = joint_kind (joints(j).kind).(field);
    for c = 1:numel (forms)
      table(end+1,:) = {func2str(forms{c}), numel(constraints.names) + 1, j, c};
      constraints.names{end+1} = joints(j).name;
      constraints.joint(end+1) = j;
    endfor
  endfor
  constraints.count = rows (table);
  if (isempty (table))
    return;
  endif
  for form = unique (table(:,1)).'
    mine = table(strcmp (table(:,1), form{1}),:);
    j = vertcat (mine{:,3});
    markers = mechanism.marker_of(j,:);
    kind = struct ("form", str2func (form{1}), "convection", str2func ([form{1} "_convection"]), ...
                   "rows", vertcat (mine{:,2}), "joints", j, ...
                   "component", vertcat (mine{:,4}), "first", markers(:,1), "second", markers(:,2));
    kind.offset = zeros (numel (j), 1);
    on_rods = arrayfun (@(joint) joint.bodies(2) > 0, joints(j));
    kind.offset(on_rods) = [joints(j(on_rods)).direction];
    first_values = arrayfun (@(j, component) joints(j).value (0)(1,component), j, kind.component);
    kind.moving = find (arrayfun (@(j) ! joints(j).constant, j)).';
    kind.constant = first_values;
    kind.constant(kind.moving) = 0;
    kind.coordinates = constraint_coordinates (form{1});
    kind.takes_offset = strcmp (form{1}, "constraint_line");
    kind.to_first = incidence (kind.first, mechanism.marker_count);
    kind.to_second = incidence (kind.second, mechanism.marker_count);
    constraints.kinds = [constraints.kinds, kind];
  endfor
endfunction

## sums what rows have onto their markers; few of them are summed faster by a full matrix
function S = incidence (markers, count)
  S = sparse (markers, 1:numel (markers), 1, count, numel (markers));
  if (numel (S) <= 100)
    S = full (S);
  endif
endfunction

%!test
%! constraints = sample_mechanism ([0 1]).mechanism.constraints;
%! assert (constraints.count, 5); assert (sort (vertcat (constraints.kinds.rows)), (1:5).');
