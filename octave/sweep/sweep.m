## -*- texinfo -*-
## @deftypefn {} {@var{found} =} sweep (@var{scene}, @var{option}, @var{value}, @dots{})
## Run a scene at many points, each in a process of its own, and leave a table: summary.csv, a row a point that is
## done, sweep.json, and sweep.html, in output/NAME/sweep/ or the folder of the option "output"; over fields that vary
## also sweep.svg and sweep.png (see @code{draw_sweep}, @code{draw_parallel}); of random points sensitivity.csv (see
## @code{sweep_sensitivity}).
##
## @var{scene} is a name or a path as for @code{driver}, whose options are those of all points.  Other options say
## which points, what of each is kept, and how they are run (see @code{sweep_settings}); a cell array as the first of
## them is a table, a row of names and a row a point.
##
## All points are checked before anything runs.  One that fails does not stop the others: it is said, and stands in
## sweep.json.  The same call again runs what is missing or failed, and no more.  A point is known by its values, the
## scene's file, the options and the program's sources.
##
## @var{found} is a struct of columns, values (a cell array, a row a point), observed (cellstr), done, message, what
## failed, and sensitivity; without it a point that failed is an error at the end.
##
## @example
## sweep ("swing", "vary", "rod.length=0.2:0.1:1; solver.tolerance=1e-4,1e-5", "observe", "max|tip_y|, model")
## @end example
## @end deftypefn

function found = sweep (scene = "paper", varargin)
  if (! isempty (varargin) && iscell (varargin{1}))
    varargin = [{"table"}, varargin];
  endif
  plan = plan_sweep (scene, varargin);
  [refused, checked, given] = check_points (scene, plan);
  [plan.units, count] = observable_units (checked, plan.items, given);
  if (plan.settings.dry)
    found = [];
    print_commands (plan, refused);
    return;
  endif
  result = run_sweep (plan, refused, checked, count);
  failed = sum (have_failed (result));
  if (nargout > 0)
    found = result;
  elseif (failed > 0)
    scene_error ("%d of %d points failed: the same command again runs them, and no others", failed, ...
                 numel (result.done));
  endif
endfunction


## what a shell takes as it is
function print_commands (plan, refused)
  for k = find (! plan.done)
    if (isempty (refused{k}))
      printf ("%s\n", plan.command (k));
    else
      printf ("# point %d, %s: %s\n", k, point_words (plan.columns, plan.values(k,:)), refused{k});
    endif
  endfor
endfunction

%!function file = write_scene (folder)   # a rod that a torque turns, a NaN where it is 0
%!  file = fullfile (folder, "driven.m");
%!  write_text (file, ["function scene = driven (torque)\n" ...
%!    "  scene.rod = struct ('length', 0.5, 'width', 0.01, 'half_height', 0.005);\n" ...
%!    "  scene.moment = @(t) 0*t + torque^2/torque;\n  scene.duration = 0.05; scene.model.modes = [0 1];\n" ...
%!    "  scene.solver = struct ('name', 'rk4', 'step', 1e-4, 'tolerance', 1e-4);\nendfunction\n"]);
%!endfunction
%!function [said, rows, json, message] = call (folder, scene, varargin)
%!  message = "";
%!  run = "try, sweep (scene, varargin{:}, 'output', folder); catch err, message = strtrim (err.message); end";
%!  said = evalc (run);
%!  lines = strsplit (strtrim (fileread (fullfile (folder, "summary.csv"))), "\n");
%!  rows = lines(2:end);
%!  json = jsondecode (fileread (fullfile (folder, "sweep.json")));
%!endfunction
%!function check_failures (folder, engine)
%!  scene = write_scene (folder);
%!  points = {"argument.1", "rod.length", "solver.step"; 1, 0.3, 1e-4};
%!  points(3:9,:) = [num2cell((2:8).'), repmat({0.4, 2e-4}, 7, 1)];
%!  bad = points; bad{4,2} = -1; bad{6,3} = 5e-3; bad{9,1} = 0;
%!  observe = {"observe", "last phi, frames", "pictures", false, "engine", engine, "jobs", 2};
%!  [said, rows, json, message] = call (folder, scene, bad, observe{:});
%!  assert (numel (rows), 5); assert ([json.done, json.failed, json.missing], [5 3 0]);
%!  assert (message, "3 of 8 points failed: the same command again runs them, and no others");
%!  assert ([json.failures.point], [3 5 8]);
%!  expected = {"^rod.length is -1: it takes positive number in m$", "^rk4 stopped at t = ", "^moment .* NaN"};
%!  assert (cellfun (@isempty, regexp ({json.failures.message}, expected, "once")), false (1, 3));
%!  assert (numel (strfind (said, "\n  point ")), 3);
%!  [said, again, json, message] = call (folder, scene, bad, observe{:});   # those that failed, as they are
%!  assert (again, rows); assert (json.failed, 3);
%!  [said, again, json, message] = call (folder, scene, points, observe{:});  # the mend
%!  assert (strncmp (said, sprintf ("8 points of %s: 5 done before, 0 refused, 3 to run by %s", scene, engine), 60));
%!  assert (message, ""); assert (setdiff (again, rows), sort (again([3 5 8]))); assert (numel (again), 8);
%!  assert (json.failures, []); assert (sort ({dir(folder).name}), {".", "..", "driven.m", "points", "scratch", ...
%!                                                                   "summary.csv", "sweep.html", "sweep.json"});
%!endfunction
%!test # 8 points, of which 3 fail: 5 rows, 3 messages; after the mend just these are run
%! in_scratch (@(folder, scratch) check_failures (folder, "make"));
%!function check_same (folder, scratch)
%!  scene = write_scene (folder);
%!  options = {"vary", "argument.1=1:1:6", "observe", "last phi, model, max|tip_y|", "jobs", 2};
%!  [said, rows] = call (scratch, scene, options{:});
%!  run = driver (fullfile (folder, "driven.m(3)"), "output", "");
%!  value = str2double (strsplit (rows{3}, ","));
%!  assert (value([3 5]), [run.history.phi(end), max(abs (run.history.tip_y))]);  # every bit
%!  assert (exist (fullfile (scratch, "sweep.png"), "file"), 2);
%!  commands = evalc ("sweep (scene, options{:}, 'output', scratch, 'dry', true);");
%!  assert (commands, "");  # all is done
%!  kept = {"vary", "argument.1=1,2", "observe", "last phi, model, max|tip_y|", "jobs", 1};
%!  said = call (scratch, scene, kept{:});
%!  assert (! isempty (strfind (said, "2 done before, 0 refused, 0 to run")));
%!  said = call (scratch, scene, kept{:}, "keep", true);
%!  assert (! isempty (strfind (said, "KEEP=yes: 2 points of some")));
%!  assert (numel (glob (fullfile (scratch, "points", "*", "history.csv"))), 2);
%!  write_text (scene, [fileread(scene) "% changed\n"]);
%!  said = call (scratch, scene, kept{:});
%!  assert (! isempty (strfind (said, "0 done before, 0 refused, 2 to run")));
%!  assert (! isempty (strfind (said, "the scene's file changed: rows of before do not count")));
%!endfunction
%!test in_scratch (@check_same);   # a row has what the run has; what is kept, and what counts, is said
%!function check_dry (folder, scratch)
%!  commands = evalc ("sweep (write_scene (folder), 'vary', 'argument.1=1,2,x', 'dry', true, 'output', scratch);");
%!  lines = strsplit (strtrim (commands), "\n");
%!  assert (numel (lines), 3); assert ({dir(scratch).name}, {".", ".."});
%!  assert (lines{3}, "# point 3, argument.1=x: argument.1 is \"x\": it takes a number");
%!  assert (system (lines{2}), 0);
%!  assert (numel (glob (fullfile (scratch, "points", "*.row"))), 1);
%!  said = call (scratch, fullfile (folder, "driven.m"), "vary", "argument.1=1,2", "pictures", false, "jobs", 1);
%!  assert (! isempty (strfind (said, "1 done before, 0 refused, 1 to run by make")));
%!endfunction
%!test in_scratch (@check_dry);   # the commands that are printed run, and count
%!test # nothing is run or written where anything of the table or of OBSERVE cannot be
%! folder = tempname ();
%! bad = {{"rod.length"; "../x"}, {"rod.length"; 1; 1}, {"rod.lenght"; 1}, {"rod.length"; "=1+2"}};
%! messages = {"it takes a number", "points 1 and 2 are the same", "rod.lenght is not a field of a scene", "it takes"};
%! for k = 1:4
%!   fail ("sweep ('swing', bad{k}, 'output', folder)", messages{k});
%! endfor
%! fail ("sweep ('swing', {'rod.length'; 1}, 'observe', 'max tip_z', 'output', folder)", "has no column tip_z");
%! fail ("sweep ('swing', {'rod.length'; 1}, 'observe', 'modes.g', 'output', folder)", "modes has no g: it has f,");
%! fail ("sweep (swing (), {'rod.length'; 1}, 'output', folder)", "a sweep takes a scene by its name or its file");
%! assert (! isfolder (folder));
