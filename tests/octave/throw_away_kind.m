## Is the table of kinds enough?  A point mass on an elastic string, a kind of one folder (tests/samples/string) and
## one row, has its run with film and report, its ladder of models, its chart and its limits of stability.

%!function scene = spring_pendulum (varargin)
%!  scene = struct ("string", struct ("length", 1, "stiffness", 1e3, "mass", 1), "duration", 0.5, ...
%!                  "frames_per_second", 20, "frame_size", [480 320]);
%!  scene.solver.tolerance = 1e-3;
%!  for field = reshape (varargin, 2, [])
%!    scene = setfield (scene, strsplit (field{1}, "."){:}, field{2});
%!  endfor
%!endfunction

%!function check_with_row (command, files, check, few)   # check (folder, what command returns)
%!  stand_ins = {"kinds = kind_table", "", "kinds = [string_kind(), exact_body_kind(), exact_kind(), surface_kind(), rod_kind(), mechanism_kind()];"
%!               "table = usable_methods", "table", ...
%!               ["table = table(ismember ({table.name}, {\"" strjoin(few, "\", \"") "\"}));"]};
%!  in_scratch (@(folder, scratch) with_stand_ins (stand_ins, @() look (command, folder, files, check)));
%!endfunction

%!function look (command, folder, files, check)
%!  evalc ("result = command (folder);");
%!  for name = files
%!    assert (stat (fullfile (folder, name{1})).size > 30);
%!  endfor
%!  check (folder, result);
%!endfunction

%!function check_run (folder, result)
%!  summary = jsondecode (fileread (fullfile (folder, "summary.json")));
%!  assert (summary.kind, "string");
%!  assert (isempty (summary.warnings));
%!  assert (summary.largest_energy_error < 1e-7);
%!  assert (summary.estimated_error_m < 1e-3);
%!  table = csvread (fullfile (folder, "history.csv"), 1, 0);
%!  assert (size (table), [11 8]);
%!  assert (table(:,3), result.y(end,:).');
%!  report = fileread (fullfile (folder, "report.html"));
%!  assert (numel (strfind (report, "<tr class=\"chosen\">")), 1);  # whatever the kind calls its models
%!  assert (isempty (strfind (report, "Derived by Maxima")));
%!endfunction
%!test # numbers, film, figures and report
%! check_with_row (@(folder) driver (spring_pendulum ("initial.phi", 0.5), "output", folder), ...
%!                 {"history.csv", "summary.json", "frames/frame_0011.png", "animation.mp4", "animation.gif", ...
%!                  "figure3.svg", "figure3.png", "figure3.pdf", "history.svg", "report.html"}, @check_run, {});

%!function check_models (folder, table)
%!  rungs = table(! strcmp ({table.method}, "ode45"));
%!  assert (sum ([rungs.chosen]), 1);
%!  assert (diff ([rungs.error_m]) <= 0);
%!  assert (rungs([rungs.chosen]).error_m < 1e-3);
%!  chart = fileread (fullfile (folder, "models.svg"));
%!  assert (! isempty (strfind (chart, "labels: elements")));
%!  assert (isempty (strfind (chart, "foreshortening")));
%!endfunction
%!test # the ladder of models: more elements, a smaller error
%! check_with_row (@(folder) model_ladder (spring_pendulum ("initial.phi", 0.5), "output", folder, "budget", 10), ...
%!                 {"models.csv", "models.svg", "models.png"}, @check_models, {});

%!function check_chart (folder, table)
%!  for name = {"ode45", "lsode_adams"}
%!    of_method = table(strcmp ({table.method}, name{1}));
%!    assert (numel (of_method) >= 2);
%!    assert ([of_method.error_m] <= 2*max ([of_method.parameter], 1e-9));
%!  endfor
%!  assert (csvread (fullfile (folder, "cost.csv"), 1, 0)(:,1), [2; 4]);
%!endfunction
%!test # the chart of methods: errors within tolerances
%! scene = spring_pendulum ("initial.phi", 0.5, "duration", 0.1, "model.modes", 1);
%! check_with_row (@(folder) work_precision (scene, "output", folder, "budget", 10), ...
%!                 {"chart.csv", "cost.csv", "chart.svg", "chart.png"}, @check_chart, {"ode45", "lsode_adams"});

%!function check_stability (folder, table)   # one spring: sqrt (k/m), with half of the string's mass
%!  limits = table(strcmp ({table.what}, "limit of the step [s]"));
%!  omega = cellfun (@stability_limit, {limits.method})./[limits.predicted];
%!  assert (omega, sqrt (1e3/1.01)*ones (size (omega)), 1e-4*31);
%!  known = isfinite ([table.predicted]) & isfinite ([table.measured]);
%!  assert (sum (known), numel (limits));
%!  assert ([table(known).measured], [table(known).predicted], -0.01);
%!endfunction
%!test # limits of stability: the frequency along the string, and each measured where it is predicted
%! check_with_row (@(folder) scene_stability (spring_pendulum ("model.modes", 1), "output", folder), ...
%!                 {"stability.csv", "stability.svg", "stability.png"}, @check_stability, {});
