## -*- texinfo -*-
## @deftypefn {} {} write_ladder (@var{table}, @var{scene}, @var{folder})
## The @var{table} of @code{model_ladder} as models.csv, and as a chart, models.svg and models.png.
## @end deftypefn

function write_ladder (table, scene, folder)
  lines = {"model,method,error [m],seconds [s],calls,chosen,extrapolated"};
  for row = table
    lines{end+1} = sprintf ("\"%s\",%s,%.17g,%.17g,%d,%d,%d", row.model, row.method, row.error_m, row.seconds, ...
                            row.calls, row.chosen, row.extrapolated);
  endfor
  write_text (fullfile (folder, "models.csv"), [strjoin(lines, "\n") "\n"]);

  scratch = fullfile (folder, "scratch");
  mkdir (scratch);
  drawn = spaced_labels (table(isfinite ([table.error_m]) & [table.error_m] > 0));
  ode45 = strcmp ({drawn.method}, "ode45");
  shortened = strcmp ({drawn.stiffening}, "foreshortening") & ! ode45;
  selected = struct ("without", ! shortened & ! ode45, "shortened", shortened, "ode45", ode45, ...
                     "chosen", [drawn.chosen]);
  settings = struct ("title", ["Ladder of models: " scene.title], "tolerance", scene.solver.tolerance);
  settings.title_size = min (18, 1300/numel (settings.title));
  blocks = "";
  for name = {"without", "shortened", "ode45", "chosen"}
    settings.(name{1}) = sum (selected.(name{1}));
    blocks = [blocks, points(name{1}, drawn(selected.(name{1})))];
  endfor
  write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), blocks]);
  finish_tool (start_gnuplot (scratch, "models.gp"));
  confirm_recursive_rmdir (false, "local");
  rmdir (scratch, "s");
endfunction

function text = points (name, rows)
  text = sprintf ("$%s << EOD\n", name);
  for row = rows
    text = [text, sprintf("%.9g %.9g \"%s\"\n", row.seconds, row.error_m, row.label)];
  endfor
  text = [text "EOD\n"];
endfunction

%!test # what a model is called in the chart
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = struct ("model", "3 bending modes, foreshortening", "method", "exponential", "error_m", 1e-3, ...
%!                 "seconds", 2, "calls", 7, "label", "3", "stiffening", "foreshortening", ...
%!                 "chosen", true, "extrapolated", false);
%!   write_ladder (row, struct ("title", "rod", "solver", struct ("tolerance", 1e-2)), folder);
%!   assert (sort ({dir(folder).name}), {".", "..", "models.csv", "models.png", "models.svg"});
%!   assert (! isempty (strfind (fileread (fullfile (folder, "models.csv")), ...
%!                               "\"3 bending modes, foreshortening\",exponential,0.001")));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
