## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} mechanism_columns (@var{scene}, @var{run})
## What history.csv has of a mechanism's @var{run} (see @code{measure_mechanism}): @var{names} with units and the
## @var{table}, a row a name, a column a time.  Every body has x_1, y_1 (end O), phi_1, phi_dot_1, psi_1 (the tangent
## there), tip_x_1, tip_y_1, V1_1_1 ...; every joint its point joint_x_1, joint_y_1 and multipliers lambda_1_1 ..., minus
## what it does to its first body (N, or N m).
## @end deftypefn

function [names, table] = mechanism_columns (scene, run)
  [model, history] = deal (run.model, run.history);
  names = {"t [s]"};
  table = history.t;
  for k = 1:numel (history.bodies)
    body = history.bodies(k);
    own = {"x_%d [m]", "y_%d [m]", "phi_%d [rad]", "phi_dot_%d [rad/s]", "psi_%d [rad]", "tip_x_%d [m]", "tip_y_%d [m]"};
    own = [own, strcat(body.V_names, {"_%d [m]"})];
    names = [names, cellfun(@(name) sprintf (name, k), own, "uniformoutput", false)];
    table = [table; body.x; body.y; body.phi; body.phi_dot; body.psi; body.tip_x; body.tip_y; body.V];
  endfor
  for j = 1:numel (scene.joints)
    marker = model.marker_of(j,1);
    rows_of = find (model.constraints.joint == j);
    units = units_of (scene.joints(j).kind, numel (rows_of));
    own = arrayfun (@(i) sprintf ("lambda_%d_%d [%s]", j, i, units{i}), 1:numel (rows_of), "uniformoutput", false);
    names = [names, {sprintf("joint_x_%d [m]", j), sprintf("joint_y_%d [m]", j)}, own];
    table = [table; history.markers.x(marker,:); history.markers.y(marker,:); history.lambda(rows_of,:)];
  endfor
  [energies, joules] = energy_columns (history);
  names = [names, energies];
  table = [table; joules];
endfunction

## of a joint's multipliers
function units = units_of (kind, count)
  kinds = joint_kinds ();
  forms = kinds(strcmp ({kinds.name}, kind)).constraints;
  units = repmat ({"N"}, 1, count);
  units(cellfun (@(form) strcmp (func2str (form), "constraint_angle"), forms)) = {"N m"};
endfunction

%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! run = struct ("model", system.mechanism, "history", measure_mechanism (system, 0, first_states (system, 0, start)));
%! [names, table] = mechanism_columns (scene, run);
%! assert (names(1:4), {"t [s]", "x_1 [m]", "y_1 [m]", "phi_1 [rad]"});
%! assert (size (table), [numel(names), 1]);
