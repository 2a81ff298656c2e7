## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} mechanism_columns (@var{scene}, @var{run})
## What history.csv has of a mechanism's @var{run} (see @code{measure_mechanism}): @var{names} with units and the
## @var{table}, a row a name, a column a time.  Every body has x_1, y_1 (end O), phi_1, phi_dot_1, psi_1 (the tangent
## there), tip_x_1, tip_y_1, V1_1_1 ..., mid_x_1, mid_y_1, tip_psi_1; every joint its point joint_x_1, joint_y_1 and
## multipliers lambda_1_1 ... (N, or N m), and one that is no load reaction_x_1, reaction_y_1, torque_1, what its
## constraints and springs do to its first body.
## @end deftypefn

function [names, table] = mechanism_columns (scene, run)
  [model, history] = deal (run.model, run.history);
  names = {"t [s]"};
  table = history.t;
  numbered = @(names, k) cellfun (@(name) sprintf (name, k), names, "uniformoutput", false);
  for k = 1:numel (history.bodies)
    body = history.bodies(k);
    own = {"x_%d [m]", "y_%d [m]", "phi_%d [rad]", "phi_dot_%d [rad/s]", "psi_%d [rad]", "tip_x_%d [m]", "tip_y_%d [m]"};
    own = [own, strcat(body.V_names, {"_%d [m]"}), {"mid_x_%d [m]", "mid_y_%d [m]", "tip_psi_%d [rad]"}];
    names = [names, numbered(own, k)];
    table = [table; body.x; body.y; body.phi; body.phi_dot; body.psi; body.tip_x; body.tip_y; body.V; ...
             body.mid_x; body.mid_y; body.tip_psi];
  endfor
  for j = 1:numel (scene.joints)
    marker = model.marker_of(j,1);
    rows_of = find (model.constraints.joint == j);
    units = units_of (scene.joints(j).kind, numel (rows_of));
    own = arrayfun (@(i) sprintf ("lambda_%d_%d [%s]", j, i, units{i}), 1:numel (rows_of), "uniformoutput", false);
    names = [names, numbered({"joint_x_%d [m]", "joint_y_%d [m]"}, j), own];
    table = [table; history.markers.x(marker,:); history.markers.y(marker,:); history.lambda(rows_of,:)];
    if (! is_load (scene.joints(j)))
      forces = history.joints(j);
      names = [names, numbered({"reaction_x_%d [N]", "reaction_y_%d [N]", "torque_%d [N m]"}, j)];
      table = [table; forces.reaction_x; forces.reaction_y; forces.torque];
    endif
  endfor
  [energies, joules] = energy_columns (history);
  names = [names, energies];
  table = [table; joules];
endfunction

## of a joint's multipliers
function units = units_of (kind, count)
  forms = joint_kind (kind).constraints;
  units = repmat ({"N"}, 1, count);
  units(cellfun (@(form) strcmp (func2str (form), "constraint_angle"), forms)) = {"N m"};
endfunction

%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! run = struct ("model", system.mechanism, "history", measure_mechanism (system, 0, start));
%! [names, table] = mechanism_columns (scene, run);
%! assert (names(1:4), {"t [s]", "x_1 [m]", "y_1 [m]", "phi_1 [rad]"});
%! assert (size (table), [numel(names), 1]);
%! value = @(name) table(strcmp (names, name));
%! assert ([value("reaction_x_2 [N]"), value("lambda_2_1 [N]")], [-1 1]*value ("lambda_2_1 [N]"));
%! assert (value ("torque_4 [N m]"), run.history.joints(4).torque);
%! assert (value ("reaction_x_6 [N]"), zeros (0, 1));  # a load
