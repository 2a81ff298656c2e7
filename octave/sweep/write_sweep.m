## -*- texinfo -*-
## @deftypefn {} {} write_sweep (@var{plan}, @var{found}, @var{state}, @var{folder})
## What a sweep of a @var{plan} (see @code{plan_sweep}) has @var{found} by now (see @code{gather_rows}), in the
## @var{folder}: summary.csv, a row a point that is done, and sweep.json, what is done, failed and missing, with the
## messages of those that failed and the fields of the struct @var{state}; and sensitivity.csv, where
## @var{found}.sensitivity has rows (see @code{sweep_sensitivity}).
## @end deftypefn

function write_sweep (plan, found, state, folder)
  done = find (found.done);
  heads = [{"point"}, plan.columns, strcat({plan.items.text}, plan.units), {"key"}];
  cells = [num2cell(done(:)), cellfun(@value_words, plan.values(done,:), "uniformoutput", false), ...
           found.observed(done,:), plan.keys(done).'];
  write_csv (fullfile (folder, "summary.csv"), heads, cells);

  cells = found.sensitivity;
  if (! isempty (cells))
    heads = {"observation", "field", "points", "standardised coefficient", "R^2", "first order index", ...
             "standard error of it"};
    cells(:,4:7) = cellfun (@(number) sprintf ("%.6g", number), cells(:,4:7), "uniformoutput", false);
    write_csv (fullfile (folder, "sensitivity.csv"), heads, cells);
  endif

  failed = find (have_failed (found));
  summary = struct ("scene", plan.typed, "columns", {plan.columns}, "observe", plan.about.observe, ...
                    "points", numel (plan.keys), "done", numel (done), "failed", numel (failed), ...
                    "missing", numel (plan.keys) - numel (done) - numel (failed), "failures", []);
  for k = failed
    summary.failures(end+1).point = k;
    summary.failures(end).at = point_words (plan.columns, plan.values(k,:));
    summary.failures(end).message = found.message{k};
    summary.failures(end).key = plan.keys{k};
  endfor
  summary.about = plan.about;
  for [value, name] = state
    summary.(name) = value;
  endfor
  write_summary (summary, fullfile (folder, "sweep.json"));
endfunction

%!function [csv, json] = written (folder, sensitivity = cell (0, 7))
%!  plan = struct ("typed", "swing", "columns", {{"a", "b"}}, "values", {{0.1 "x"; [0 4] "y"; 3 "z"; 4 "w"}}, ...
%!                 "keys", {{"k", "l", "m", "n"}}, "units", {{" [m]", ""}}, "about", struct ());
%!  plan.about.observe = "max u, model";
%!  plan.items = struct ("text", {"max u", "model"});
%!  found = struct ("observed", {{"0.5", "6, \"rigid\""; "1", ""; "", ""; "", ""}}, ...
%!                  "done", [true true false false], "message", {{"", "", "it failed", ""}}, ...
%!                  "sensitivity", {sensitivity});
%!  write_sweep (plan, found, struct ("jobs", 2), folder);
%!  csv = fileread (fullfile (folder, "summary.csv"));
%!  json = jsondecode (fileread (fullfile (folder, "sweep.json")));
%!  assert (exist (fullfile (folder, "sensitivity.csv"), "file") > 0, ! isempty (sensitivity));
%!  if (! isempty (sensitivity))
%!    csv = fileread (fullfile (folder, "sensitivity.csv"));
%!  endif
%!endfunction
%!test
%! [csv, json] = in_scratch (@(folder, scratch) written (folder));
%! assert (csv, "point,a,b,max u [m],model,key\n1,0.1,x,0.5,\"6, \"\"rigid\"\"\",k\n2,0 4,y,1,,l\n");
%! assert ([json.points, json.done, json.failed, json.missing, json.jobs], [4 2 1 1 2]);
%! assert (json.failures, struct ("point", 3, "at", "a=3; b=z", "message", "it failed", "key", "m"));
%!test # of random points
%! csv = in_scratch (@(folder, scratch) written (folder, {"max u, v", "a", 50, 0.25, 0.5, NaN, 0.01}));
%! assert (strsplit (csv, "\n"){2}, "\"max u, v\",a,50,0.25,0.5,NaN,0.01");
