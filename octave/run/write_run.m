## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} write_run (@var{output}, @var{kind}, @var{scene}, @var{run}, @var{summary}, @
##   @var{start})
## All files of a @var{run} of a scene of a @var{kind} (see @code{kind_of}) into the folder of @var{output} (see
## @code{take_options}), and what a person at the terminal wants to know of it.  The numbers come first, history.csv,
## end.csv and summary.json, then dense.csv, where it is wanted, and the pictures of the kind's drawing (see
## @code{draw_pictures}); what of them cannot be made is a warning.  The summary comes back with that, and with the
## seconds of each part, those since @var{start} (a tic).
## @end deftypefn

function summary = write_run (output, kind, scene, run, summary, start)
  folder = output.folder;
  if (isempty (folder))
    return;
  endif
  [names, pictures] = run_files ();
  draw = @() run_drawing (kind, scene, run);
  summary.seconds.pictures = 0;
  summary.seconds.total = toc (start);
  ## The pictures of the last run go before its numbers do: they would not belong to these.
  publish_run (folder, [pictures, names], @write_numbers);
  if (! isempty (output.dense))
    try
      publish_run (folder, {"dense.csv"}, @write_dense);
    catch err
      warn ("dense.csv is missing: %s", err.message);
    end_try_catch
  endif
  if (output.pictures)
    try
      publish_run (folder, pictures, @draw_all);
    catch err
      warn ("pictures are missing: %s", err.message);
    end_try_catch
    summary.seconds.total = toc (start);
    try
      publish_run (folder, {"summary.json"}, @write_last);
    catch err
      warn ("summary.json lacks the seconds and the warnings of the pictures: %s", err.message);
    end_try_catch
    names = [names, strtok(pictures, "/")];
  endif
  names = names(cellfun (@(name) exist (fullfile (folder, name)) > 0, names));
  cellfun (@(line) say ("%s", line), closing_lines (output, summary, names));

  function write_numbers (aside)
    write_columns (kind, scene, run, fullfile (aside, "history.csv"));
    write_end (kind, scene, run, aside);
    write_last (aside);
  endfunction

  function write_dense (aside)
    write_columns (kind, scene, dense_run (kind, scene, run, output.dense), fullfile (aside, "dense.csv"));
  endfunction

  function write_last (aside)
    write_summary (summary, fullfile (aside, "summary.json"));
  endfunction

  function draw_all (aside)
    summary = draw_run (aside, output.given, summary, start, draw, folder);
  endfunction

  function warn (template, message)
    summary.warnings{end+1} = sprintf (template, strtrim (message));
  endfunction
endfunction

function write_columns (kind, scene, run, file)
  [names, table] = kind.columns (scene, run);
  write_csv (file, names, table.');
endfunction

%!function check_files (folder, scratch)
%!  evalc ("result = driver ('paper', 'modes', [0 0], 'output', folder);");
%!  assert (result.summary.warnings, {});
%!  assert (numel (glob (fullfile (folder, "frames", "*.png"))), 91);
%!  assert (rows (csvread (fullfile (folder, "history.csv"), 1, 0)), 91);
%!  assert (jsondecode (fileread (fullfile (folder, "summary.json"))).frames, 91);
%!  for name = {"animation.mp4", "animation.gif", "figure3.svg", "history.svg", "report.html"}
%!    assert (stat (fullfile (folder, name{1})).size > 10000);
%!  endfor
%!endfunction
%!test in_scratch (@check_files); # every file of a run is there
%!function check_dense (folder, scratch)
%!  lines = @(name) strsplit (fileread (fullfile (folder, name)), "\n");
%!  evalc ("driver ('paper', 'modes', [0 0], 'pictures', false, 'output', folder, 'dense', 1e3);");
%!  assert (lines ("dense.csv"){1}, lines ("history.csv"){1});
%!  table = @(name) csvread (fullfile (folder, name), 1, 0);
%!  assert (table ("dense.csv")(1:20:end,:), table ("history.csv"), 1e-6);
%!  evalc ("driver ('paper', 'modes', [0 0], 'pictures', false, 'output', folder);");
%!  assert (exist (fullfile (folder, "dense.csv")), 0);  # it would be of another run
%!endfunction
%!test in_scratch (@check_dense);
%!function check_without_pictures (folder)
%!  evalc ("result = driver ('paper', 'modes', [0 0], 'output', folder);");
%!  written = jsondecode (fileread (fullfile (folder, "summary.json")));
%!  assert (result.summary.warnings, {"pictures are missing: no ink"});
%!  assert (written.warnings, {"pictures are missing: no ink"});
%!  assert (written.seconds.total >= written.seconds.integration); assert (written.seconds.pictures, 0);
%!  assert (sort ({dir(folder).name}), {".", "..", "end.csv", "history.csv", "scratch", "summary.json"});
%!endfunction
%!test # where nothing can be drawn, the numbers are there, and the summary says why there is no more
%! stand_in = {"summary = draw_run", "varargin", "error (\"no ink\\n\");"};
%! in_scratch (@(folder, scratch) with_stand_ins (stand_in, @() check_without_pictures (folder)));
