## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} rod_columns (@var{scene}, @var{run})
## What history.csv has of a rod's @var{run} (see @code{measure}): @var{names} with units and the @var{table}, a row a
## name, a column a time; the torque is a hub's, and every joint has its point joint_x_1, joint_y_1.
## @end deftypefn

function [names, table] = rod_columns (scene, run)
  history = run.history;
  [energies, joules] = energy_columns (history);
  names = [{"t [s]", "phi [rad]", "phi_dot [rad/s]", "psi [rad]", "tip_x [m]", "tip_y [m]"}, ...
           strcat(history.V_names, {" [m]"}), energies];
  table = [history.t; history.phi; history.phi_dot; history.psi; history.tip_x; history.tip_y; history.V; joules];
  if (! isempty (history.torque))
    names{end+1} = "torque [N m]";
    table(end+1,:) = history.torque;
  endif
  if (! isempty (history.joints))
    for j = 1:rows (history.joints.x)
      names = [names, {sprintf("joint_x_%d [m]", j), sprintf("joint_y_%d [m]", j)}];
      table = [table; history.joints.x(j,:); history.joints.y(j,:)];
    endfor
  endif
endfunction

%!test
%! history = struct ("t", [0 0.1], "phi", [1 2], "phi_dot", [3 4], "psi", [5 6], "tip_x", [7 8], "tip_y", [9 10], ...
%!                   "V", [pi 2], "V_names", {{"V2_1"}}, "T", [1 2], "U", [3 4], "Z", [5 6], "W", [7 8], ...
%!                   "D", [9 10], "torque", [], "joints", []);
%! [names, table] = rod_columns ([], struct ("history", history));
%! assert (strjoin (names, ","), ["t [s],phi [rad],phi_dot [rad/s],psi [rad],tip_x [m],tip_y [m],V2_1 [m]," ...
%!                                "T [J],U [J],Z [J],W [J],D [J]"]);
%! assert (table(7,:), [pi 2]);
%! [names, table] = rod_columns ([], struct ("history", setfield (history, "torque", [3 4])));
%! assert (names{end}, "torque [N m]"); assert (table(end,:), [3 4]);
%! history.joints = struct ("x", [1 2; 3 4], "y", [5 6; 7 8]);
%! [names, table] = rod_columns ([], struct ("history", history));
%! assert (names{end}, "joint_y_2 [m]"); assert (table(end-3:end,:), [1 2; 5 6; 3 4; 7 8]);
