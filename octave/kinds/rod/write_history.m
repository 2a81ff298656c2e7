## -*- texinfo -*-
## @deftypefn {} {} write_history (@var{history}, @var{file})
## The history (see @code{measure}) as CSV: a header of names with units, a row a time, 17 significant digits.
## @end deftypefn

function write_history (history, file)
  names = {"t [s]", "phi [rad]", "phi_dot [rad/s]", "psi [rad]", "tip_x [m]", "tip_y [m]"};
  names = [names, strcat(history.V_names, {" [m]"}), ...
           {"T [J]", "U [J]", "Z [J]", "W [J]", "D [J]"}, repmat({"torque [N m]"}, 1, rows (history.torque))];
  table = [history.t; history.phi; history.phi_dot; history.psi; history.tip_x; history.tip_y; ...
           history.V; history.T; history.U; history.Z; history.W; history.D; history.torque];
  text = [strjoin(names, ","), "\n", sprintf([repmat("%.17g,", 1, rows (table) - 1), "%.17g\n"], table)];
  write_text (file, text);
endfunction

%!test
%! history = struct ("t", [0 0.1], "phi", [1 2], "phi_dot", [3 4], "psi", [5 6], "tip_x", [7 8], "tip_y", [9 10], ...
%!                   "V", [pi 2], "V_names", {{"V2_1"}}, "T", [1 2], "U", [3 4], "Z", [5 6], "W", [7 8], ...
%!                   "D", [9 10], "torque", []);
%! file = tempname ();
%! unwind_protect
%!   write_history (history, file);
%!   text = fileread (file);
%!   header = "t [s],phi [rad],phi_dot [rad/s],psi [rad],tip_x [m],tip_y [m],V2_1 [m],T [J],U [J],Z [J],W [J],D [J]\n";
%!   assert (strncmp (text, header, numel (header)));
%!   assert (csvread (file, 1, 0)(1,7), pi);
%! unwind_protect_cleanup
%!   unlink (file);
%! end_unwind_protect
