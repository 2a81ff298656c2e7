## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_ladder (@var{table}, @var{labels}, @var{scene}, @var{scratch})
## The @var{table} of @code{model_ladder} as a chart, models.svg and models.png beside the folder @var{scratch}, which
## takes the data; @var{labels} (a text) says what the labels are.  They are there when @var{job} has ended (see
## @code{finish_tool}).
## @end deftypefn

function job = draw_ladder (table, labels, scene, scratch)
  drawn = spaced_labels (table(isfinite ([table.error_m]) & [table.error_m] > 0));
  ode45 = strcmp ({drawn.method}, "ode45");
  longer = ode45 & [drawn.part] < 1;  # extrapolated from a part of the duration
  settings = struct ("title", ["Ladder of models: " scene.title], "tolerance", scene.solver.tolerance, ...
                     "labels", labels, "curves", {fliplr(unique ({table.curve}))}, "ode45", sum (ode45 & ! longer), ...
                     "extrapolated", sum (longer), "chosen", sum ([drawn.chosen]));
  settings.title_size = min (18, 1300/numel (settings.title));
  settings.counts = {};
  blocks = [labelled_points("ode45", drawn(ode45 & ! longer)), labelled_points("extrapolated", drawn(longer)), ...
            labelled_points("chosen", drawn([drawn.chosen]))];
  for k = 1:numel (settings.curves)
    of_curve = strcmp ({drawn.curve}, settings.curves{k}) & ! ode45;
    settings.counts{k} = sum (of_curve);
    blocks = [blocks, labelled_points(sprintf ("curve_%d", k), drawn(of_curve))];
  endfor
  write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), blocks]);
  job = start_gnuplot (scratch, "models.gp");
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! row = struct ("method", "exponential", "error_m", 1e-3, "seconds", 2, "label", "3", ...
%!               "curve", {"no foreshortening", "with foreshortening"}, "chosen", {false, true}, "part", 1);
%! scene = struct ("title", "it's a \"rod\" {1}", "solver", struct ("tolerance", 1e-2));
%! draw = {@(scratch) draw_ladder(row, "it's a number", scene, scratch)};
%! assert (draw_files (folder, draw, {"models.svg", "models.png"}), cell (0, 2));
%!function text = settings_of (table, scene, scratch)
%!  finish_tool (draw_ladder (table, "modes", scene, scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # points of each curve, of ode45 and of what is chosen; what has no error above 0 has no place on the axis
%! table = struct ("method", {"exponential", "waveform", "ode45", "waveform", "waveform", "ode45"}, ...
%!                 "seconds", {2 4 8 1 1 99}, "error_m", {1e-3 1e-5 1e-6 0 NaN 1e-8}, ...
%!                 "label", {"3" "5" "7" "8" "9" "7+7"}, "curve", {"a", "b", "b", "b", "b", "b"}, ...
%!                 "chosen", {false true false false false false}, "part", {1 1 1 1 1 0.2});
%! scene = struct ("title", repmat ("t", 1, 182), "solver", struct ("tolerance", 1e-2));
%! text = in_scratch (@(folder, scratch) settings_of (table, scene, scratch));
%! for part = {"tolerance = 0.01", "labels = 'modes'", "array curves[2] = ['b', 'a']", "ode45 = 1", "chosen = 1", ...
%!             "title_size = 6.5", "array counts[2] = [1, 1]", "$ode45 << EOD\n8 1e-06 \"7\"\nEOD", ...
%!             "extrapolated = 1", "$extrapolated << EOD\n99 1e-08 \"7+7\"\nEOD", ...
%!             "$chosen << EOD\n4 1e-05 \"5\"\nEOD", "$curve_1 << EOD\n4 1e-05 \"5\"\nEOD", ...
%!             "$curve_2 << EOD\n2 0.001 \"3\"\nEOD"}
%!   assert (numel (strfind (text, [part{1} "\n"])) == 1, "%s", part{1});
%! endfor
%! scene.title = "";
%! text = in_scratch (@(folder, scratch) settings_of (table(1), scene, scratch));
%! assert (! isempty (strfind (text, "title_size = 18\n")));
