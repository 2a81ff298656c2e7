## -*- texinfo -*-
## @deftypefn {} {@var{found} =} run_sweep (@var{plan}, @var{refused}, @var{scene}, @var{count})
## Run the points of a @var{plan} (see @code{plan_sweep}) that are not done and not @var{refused} (see
## @code{check_points}), and publish summary.csv, sweep.json and sweep.html before, as points end, and behind, where
## they are random with sensitivity.csv; then sweep.svg and sweep.png, where fields vary.  @var{scene} is
## one of the points', checked, and @var{count} the number of columns that its runs have about.  @var{found} is what
## @code{sweep} returns.
## @end deftypefn

function found = run_sweep (plan, refused, scene, count)
  start = tic ();
  to_do = find (! plan.done & cellfun (@isempty, refused) & ! plan.settings.gather);
  [engine, jobs] = engine_here (plan.settings);
  [numbers, pictures] = deal ({"summary.csv", "sweep.json", "sweep.html"}, {"sweep.svg", "sweep.png"});
  if (! isempty (plan.settings.random))
    numbers{end+1} = "sensitivity.csv";
  endif
  if (! isempty (plan.settings.hosts) && ! isempty (to_do))
    refuse_hosts (plan.settings.hosts, plan);
  endif
  points = fullfile (plan.folder, "points");
  require_folder (points);
  announce_sweep (plan, refused, to_do, engine, jobs);
  announce_disk (plan, numel (to_do), numel (frame_times (scene)), count, scene.frame_size);
  for key = plan.keys(! plan.done & ! plan.settings.gather)
    [~, ~] = unlink (fullfile (points, [key{1} ".row"]));
    [~, ~] = unlink (fullfile (points, [key{1} ".failed"]));
  endfor
  found = struct ("observed", {repmat({""}, numel (plan.keys), numel (plan.items))}, ...
                  "done", false (1, numel (plan.keys)), "message", {refused}, ...
                  "sensitivity", {cell(0, 7)});
  found = gather_rows (plan, found);
  publish (found);
  if (! isempty (to_do))
    found = follow_sweep (plan, found, to_do, engine, jobs, @publish);
  endif
  [found.columns, found.values] = deal (plan.columns, plan.values);
  found.sensitivity = sweep_sensitivity (plan, found);
  tell_failures (plan, found);
  drawn = drawn_sweep (found, strcat ({plan.items.text}, plan.units));
  draw = @draw_sweep;
  if (numel (drawn.names) > 2)
    draw = @draw_parallel;
  endif
  output = struct ("folder", plan.folder, "pictures", plan.pictures && ! isempty (drawn.x));
  publish_study (output, numbers, pictures, ...
                 @(aside) write (found, false, aside), @(scratch) draw (drawn, scene.title, scratch));
  if (exist (fullfile (plan.folder, "sweep.svg"), "file"))
    publish_run (plan.folder, {"sweep.html"}, ...
                 @(aside) write_sweep_page (plan, found, state_of (false), {"sweep.svg"}, aside));
  endif

  function publish (found)
    publish_run (plan.folder, [numbers, pictures], @(aside) write (found, true, aside));
  endfunction

  function write (found, running, aside)
    write_sweep (plan, found, state_of (running), aside);
    write_sweep_page (plan, found, state_of (running), {}, aside);
  endfunction

  function state = state_of (running)
    state = struct ("running", running, "engine", engine, "jobs", jobs, "seconds", toc (start));
  endfunction
endfunction

function tell_failures (plan, found)
  failed = find (have_failed (found));
  for k = failed(1:min (end, 10))
    say ("  point %d, %s: %s", k, point_words (plan.columns, plan.values(k,:)), found.message{k});
  endfor
  if (numel (failed) > 10)
    say ("  and %d more, in sweep.json", numel (failed) - 10);
  endif
endfunction

%!function [found, said] = run_of (folder, rows, varargin)   # of 13 points, of which so many have left rows
%!  plan = struct ("folder", folder, "typed", "x", "done", (1:13) <= rows, "pictures", true, "drawn", false);
%!  plan.keys = arrayfun (@(k) sprintf ("k%d", k), 1:13, "uniformoutput", false);
%!  [plan.columns, plan.values, plan.items] = deal ({"a"}, num2cell ((1:13).'), struct ("text", "u"));
%!  plan.units = {" [m]"};
%!  plan.settings = take_settings ({"engine", "make", "jobs", 1, varargin{:}});
%!  plan.about = struct ("observe", "u"); [plan.name, plan.call] = deal ("x", "make sweep SCENE=x");
%!  scene = struct ("title", "A rod", "duration", 1, "frames_per_second", 10, "frame_size", [1280 720]);
%!  mkdir (fullfile (folder, "points"));
%!  refused = repmat ({"no"}, 1, 13); refused(1:rows) = {""};
%!  for k = 1:rows
%!    write_text (fullfile (folder, "points", sprintf ("k%d.row", k)), sprintf ("%.1f\n", k/2));
%!  endfor
%!  said = evalc ("found = run_sweep (plan, refused, scene, 7);");
%!  assert (found.done, plan.done); assert (found.values, plan.values); assert (found.columns, {"a"});
%!endfunction
%!function check (folder)
%!  [~, said] = run_of (folder, 1);
%!  lines = strsplit (strtrim (said), "\n");
%!  assert (lines(2:3), {"  point 2, a=2: no", "  point 3, a=3: no"});
%!  assert (lines(end-1:end), {"  and 2 more, in sweep.json", ...
%!                             [folder "/ has summary.csv, sweep.json, sweep.html, sweep.svg, sweep.png"]});
%!  assert (numel (strfind (said, "\n  point ")), 10);
%!  assert (fileread (fullfile (folder, "summary.csv")), "point,a,u [m],key\n1,1,0.5,k1\n");
%!  assert (jsondecode (fileread (fullfile (folder, "sweep.json"))).running, false);
%!  assert (! isempty (strfind (fileread (fullfile (folder, "sweep.html")), "<img src=\"sweep.svg\"")));
%!endfunction
%!test in_scratch (@(folder, scratch) check (folder));   # where nothing can be run
%!function check_random (folder)
%!  found = run_of (folder, 13, "vary", "a=1..13", "random", 13);
%!  assert (found.sensitivity(1:3), {"u", "a", 13}); assert ([found.sensitivity{4:6}], [1 1 1], 1e-12);
%!  assert (! isempty (strfind (fileread (fullfile (folder, "sensitivity.csv")), "\nu,a,13,1,1,1,")));
%!  assert (! isempty (strfind (fileread (fullfile (folder, "sweep.html")), "<h2 id=\"sensitivity\">")));
%!endfunction
%!test in_scratch (@(folder, scratch) check_random (folder));   # of random points how much a field matters
