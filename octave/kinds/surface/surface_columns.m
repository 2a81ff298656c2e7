## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} surface_columns (@var{scene}, @var{run})
## What history.csv has of a @var{run} of a rod on a surface (see @code{measure_surface}): @var{names} with units and
## the @var{table}, a row a name, a column a time.  The coefficients have the unit of the chart's coordinate;
## smallest_reaction and largest_reaction are those of the normal reaction per length, reaction_x, reaction_y,
## reaction_z all that holds the rod.
## @end deftypefn

function [names, table] = surface_columns (scene, run)
  history = run.history;
  [energies, joules] = energy_columns (history);
  units = history.units(1 + strncmp (history.q_names, "alpha2", 6));
  coefficients = strcat (history.q_names, {" ["}, units, {"]"});
  names = [{"t [s]", "tip_x [m]", "tip_y [m]", "tip_z [m]"}, coefficients, energies, ...
           {"angular_momentum_x [kg m^2/s]", "angular_momentum_y [kg m^2/s]", "angular_momentum_z [kg m^2/s]", ...
            "smallest_reaction [N/m]", "largest_reaction [N/m]", "mid_x [m]", "mid_y [m]", "mid_z [m]", ...
            "psi [rad]", "tip_psi [rad]", "reaction_x [N]", "reaction_y [N]", "reaction_z [N]"}];
  names = [names, repmat({"torque [N m]"}, 1, rows (history.torque))];
  names = [names, repmat({"tip_reaction [N]"}, 1, rows (history.tip_reaction))];
  table = [history.t; history.tip; history.q; joules; history.angular_momentum; ...
           min(history.reaction, [], 1); max(history.reaction, [], 1); history.mid; ...
           history.psi; history.tip_psi; history.support; history.torque; history.tip_reaction];
endfunction

%!test
%! history = struct ("t", 0, "tip", [1; 2; 3], "q", [4; 5], "T", 6, "U", 7, "Z", 8, "W", 9, "D", 0, ...
%!                   "angular_momentum", [1; 2; 3], "reaction", [-1; 2], "mid", [3; 4; 5], "psi", 6, "tip_psi", 7, ...
%!                   "support", [8; 9; 10], "torque", zeros (0, 1), "tip_reaction", zeros (0, 1));
%! [history.q_names, history.units] = deal ({"alpha1_0", "alpha2_0"}, {"m", "rad"});
%! [names, table] = surface_columns ([], struct ("history", history));
%! assert (names(5:6), {"alpha1_0 [m]", "alpha2_0 [rad]"});
%! assert (table.', [0 1 2 3 4 5 6 7 8 9 0 1 2 3 -1 2 3:10]); assert (numel (names), 24);
%! [names, table] = surface_columns ([], struct ("history", setfield (history, "torque", 4)));
%! assert (table(end), 4); assert (names{end}, "torque [N m]");
