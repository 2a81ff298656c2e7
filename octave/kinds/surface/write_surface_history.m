## -*- texinfo -*-
## @deftypefn {} {} write_surface_history (@var{history}, @var{file})
## The history of a rod on a surface (see @code{measure_surface}) as CSV: a header of names with units, a row a time,
## 17 significant digits.  The coefficients have the unit of the chart's coordinate.
## @end deftypefn

function write_surface_history (history, file)
  names = [{"t [s]", "tip_x [m]", "tip_y [m]", "tip_z [m]"}, history.q_names, ...
           {"T [J]", "U [J]", "Z [J]", "W [J]", "D [J]", "angular_momentum_x [kg m^2/s]", ...
            "angular_momentum_y [kg m^2/s]", "angular_momentum_z [kg m^2/s]", ...
            "smallest_reaction [N/m]", "largest_reaction [N/m]"}];
  table = [history.t; history.tip; history.q; history.T; history.U; history.Z; history.W; history.D; ...
           history.angular_momentum; min(history.reaction, [], 1); max(history.reaction, [], 1)];
  text = [strjoin(names, ","), "\n", sprintf([repmat("%.17g,", 1, rows (table) - 1), "%.17g\n"], table)];
  write_text (file, text);
endfunction

%!test
%! file = tempname ();
%! unwind_protect
%!   history = struct ("t", 0, "tip", [1; 2; 3], "q", [4; 5], "T", 6, "U", 7, "Z", 8, "W", 9, "D", 0, ...
%!                     "angular_momentum", [1; 2; 3], "reaction", [-1; 2]);
%!   history.q_names = {"alpha1_0", "alpha2_0"};
%!   write_surface_history (history, file);
%!   assert (csvread (file, 1, 0), [0 1 2 3 4 5 6 7 8 9 0 1 2 3 -1 2]);
%! unwind_protect_cleanup
%!   unlink (file);
%! end_unwind_protect
