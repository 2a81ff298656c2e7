## -*- texinfo -*-
## @deftypefn {} {} write_mechanism_history (@var{scene}, @var{mechanism}, @var{history}, @var{file})
## The history (see @code{measure_mechanism}) as CSV: a header of names with units, a row a time, 17 significant
## digits.  Every body has its columns x_1, y_1 (end O), phi_1, phi_dot_1, tip_x_1, tip_y_1, V1_1_1 ...; every joint
## its point joint_x_1, joint_y_1 and multipliers lambda_1_1 ..., minus what it does to its first body (N, or N m).
## @end deftypefn

function write_mechanism_history (scene, mechanism, history, file)
  names = {"t [s]"};
  table = history.t;
  for k = 1:numel (history.bodies)
    body = history.bodies(k);
    own = {"x_%d [m]", "y_%d [m]", "phi_%d [rad]", "phi_dot_%d [rad/s]", "tip_x_%d [m]", "tip_y_%d [m]"};
    own = [own, strcat(body.V_names, {"_%d [m]"})];
    names = [names, cellfun(@(name) sprintf (name, k), own, "uniformoutput", false)];
    table = [table; body.x; body.y; body.phi; body.phi_dot; body.tip_x; body.tip_y; body.V];
  endfor
  for j = 1:numel (scene.joints)
    marker = mechanism.marker_of(j,1);
    rows_of = find (mechanism.constraints.joint == j);
    kind = scene.joints(j).kind;
    units = repmat ({"N"}, 1, numel (rows_of));
    units(cellfun (@(form) strcmp (func2str (form), "constraint_angle"), forms_of (kind))) = {"N m"};
    own = arrayfun (@(i) sprintf ("lambda_%d_%d [%s]", j, i, units{i}), 1:numel (rows_of), "uniformoutput", false);
    names = [names, {sprintf("joint_x_%d [m]", j), sprintf("joint_y_%d [m]", j)}, own];
    table = [table; history.markers.x(marker,:); history.markers.y(marker,:); history.lambda(rows_of,:)];
  endfor
  names = [names, {"T [J]", "U [J]", "Z [J]", "W [J]", "D [J]"}];
  table = [table; history.T; history.U; history.Z; history.W; history.D];
  text = [strjoin(names, ","), "\n", sprintf([repmat("%.17g,", 1, rows (table) - 1), "%.17g\n"], table)];
  write_text (file, text);
endfunction

function forms = forms_of (kind)
  kinds = joint_kinds ();
  forms = kinds(strcmp ({kinds.name}, kind)).constraints;
endfunction

%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, 0, first_states (system, 0, start));
%! file = tempname ();
%! unwind_protect
%!   write_mechanism_history (scene, system.mechanism, history, file);
%!   text = fileread (file);
%!   assert (strncmp (text, "t [s],x_1 [m],y_1 [m],phi_1 [rad],", 30));
%!   assert (numel (strsplit (strtok (text, "\n"), ",")), numel (csvread (file, 1, 0)));
%! unwind_protect_cleanup
%!   unlink (file);
%! end_unwind_protect
