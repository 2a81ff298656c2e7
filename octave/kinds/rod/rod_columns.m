## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} rod_columns (@var{scene}, @var{run})
## What history.csv has of a rod's @var{run} (see @code{measure}): @var{names} with units and the @var{table}, a row a
## name, a column a time; the torque is a hub's, the reaction what the hinge or the hub does to the rod; every joint
## has its point joint_x_1, joint_y_1.
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
  names = [names, {"mid_x [m]", "mid_y [m]", "tip_psi [rad]", "reaction_x [N]", "reaction_y [N]"}];
  table = [table; history.mid_x; history.mid_y; history.tip_psi; history.reaction_x; history.reaction_y];
  if (! isempty (history.joint_points))
    for j = 1:rows (history.joint_points.x)
      names = [names, {sprintf("joint_x_%d [m]", j), sprintf("joint_y_%d [m]", j)}];
      table = [table; history.joint_points.x(j,:); history.joint_points.y(j,:)];
    endfor
  endif
endfunction

%!test
%! history = struct ("t", [0 0.1], "phi", [1 2], "phi_dot", [3 4], "psi", [5 6], "tip_x", [7 8], "tip_y", [9 10], ...
%!                   "V", [pi 2], "V_names", {{"V2_1"}}, "T", [1 2], "U", [3 4], "Z", [5 6], "W", [7 8], ...
%!                   "D", [9 10], "torque", [], "joint_points", [], "mid_x", [1 1], "mid_y", [2 2], "tip_psi", [3 3], ...
%!                   "reaction_x", [4 4], "reaction_y", [5 5]);
%! [names, table] = rod_columns ([], struct ("history", history));
%! assert (strjoin (names, ","), ["t [s],phi [rad],phi_dot [rad/s],psi [rad],tip_x [m],tip_y [m],V2_1 [m]," ...
%!                                "T [J],U [J],Z [J],W [J],D [J]," ...
%!                                "mid_x [m],mid_y [m],tip_psi [rad],reaction_x [N],reaction_y [N]"]);
%! assert (table(7,:), [pi 2]); assert (table(end-4:end,1), (1:5).');
%! [names, table] = rod_columns ([], struct ("history", setfield (history, "torque", [3 4])));
%! assert (names{end-5}, "torque [N m]"); assert (table(end-5,:), [3 4]);
%! history.joint_points = struct ("x", [1 2; 3 4], "y", [5 6; 7 8]);
%! [names, table] = rod_columns ([], struct ("history", history));
%! assert (names{end}, "joint_y_2 [m]"); assert (table(end-3:end,:), [1 2; 5 6; 3 4; 7 8]);
