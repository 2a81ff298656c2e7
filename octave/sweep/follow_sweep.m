## -*- texinfo -*-
## @deftypefn {} {@var{found} =} follow_sweep (@var{plan}, @var{found}, @var{to_do}, @var{engine}, @var{jobs}, @
##   @var{publish})
## Let an @var{engine} (see @code{engine_command}) run those points @var{to_do} of a @var{plan}, so many @var{jobs} at
## a time, and @var{publish} (found) what there is at any time (see @code{gather_rows}); on a terminal a line has how
## many points are done and failed, and the seconds left.  A point that leaves nothing has failed, too.
## @end deftypefn

function found = follow_sweep (plan, found, to_do, engine, jobs, publish)
  folder = fullfile (plan.folder, "engine");
  confirm_recursive_rmdir (false, "local");
  [~, ~] = rmdir (folder, "s");  # of a sweep that was killed
  mkdir (folder);
  commands = arrayfun (plan.command, to_do, "uniformoutput", false);
  gather = "";
  if (strcmp (engine, "slurm"))
    gather = gather_command (plan, folder);
  endif
  command = engine_command (engine, jobs, plan.settings, folder, plan.keys(to_do), commands, gather);
  job = start_tool (folder, engine, command);
  ended = false;
  unwind_protect
    found = watch (plan, found, job.pid, publish, strcmp (engine, "slurm"));
    ended = true;
    for k = find (! found.done & ! have_failed (found))
      found.message{k} = ["its process ended and did not say why: " last_words(job.log)];
    endfor
  unwind_protect_cleanup
    if (! ended && ! strcmp (engine, "slurm"))  # a queue goes on without who waits for it
      kill (job.pid, SIG ().TERM);
    endif
    show_progress ("");
    [~, ~] = unlink (job.log);
    if (ended && ! strcmp (engine, "slurm"))  # its last job may be waiting
      [~, ~] = rmdir (folder, "s");
    endif
  end_unwind_protect
endfunction

## Looking takes a twentieth of the time, at most.  A queue says late that it is empty.
function found = watch (plan, found, pid, publish, is_queue)
  start = tic ();
  begun = counted (found);
  look = tic ();
  seconds = 0;
  do
    [ended, ~] = waitpid (pid, WNOHANG ());
    if (ended != 0 || toc (look) > 20*seconds)
      look = tic ();
      before = counted (found);
      found = gather_rows (plan, found);
      if (counted (found) != before)
        publish (found);
      endif
      show_progress (sweep_progress (found, counted (found) - begun, toc (start)));
      seconds = toc (look);
    endif
    pause (0.2*(ended == 0));
  until (ended != 0 || (is_queue && counted (found) == numel (plan.keys)))
endfunction

function n = counted (found)
  n = sum (found.done) + sum (have_failed (found));
endfunction

function text = sweep_progress (found, news, seconds)
  failed = sum (have_failed (found));
  text = sprintf ("%d of %d points done, %d failed", sum (found.done), numel (found.done), failed);
  if (news > 0)
    left = numel (found.done) - sum (found.done) - failed;
    text = [text, sprintf(", %.0f s left ", left*seconds/news)];
  endif
endfunction

function text = last_words (log)
  text = strtrim (fileread (log));
  text = text(max ([1, rindex(text, "\n") + 1]):end);
  if (isempty (text))
    text = "it was killed, say";
  endif
endfunction

%!function note_down (file, found)
%!  id = fopen (file, "a");
%!  fprintf (id, "%d\n", sum (found.done) + sum (have_failed (found)));
%!  fclose (id);
%!endfunction
%!function check (folder)
%!  points = fullfile (folder, "points"); mkdir (points);
%!  plan = struct ("folder", folder, "keys", {{"a", "b", "c", "d"}}, "settings", take_settings ({}));
%!  commands = {"false", "echo 1 >points/b.row; sleep 1.5", "echo no >points/c.failed; false", ...
%!              "echo 'the last word' >&2; kill -9 $$"};
%!  plan.command = @(k) strrep (commands{k}, "points/", [points "/"]);
%!  found = struct ("observed", {{"5"; ""; ""; ""}}, "done", [true false false false], "message", {{"", "", "", ""}});
%!  note = fullfile (folder, "noted");
%!  found = follow_sweep (plan, found, [2 3 4], "make", 1, @(found) note_down (note, found));
%!  assert (found.done, [true true false false]); assert (found.observed, {"5"; "1"; ""; ""});
%!  assert (found.message(1:3), {"", "", "no"});
%!  assert (! isempty (regexp (found.message{4}, "^its process ended and did not say why: .")));
%!  assert (fileread (note)(1:2), "2\n");  # while the second sleeps
%!  delete (note);
%!  assert (sort ({dir(folder).name}), {".", "..", "points", "scratch"});
%!endfunction
%!test # the line of progress is cleared in the end
%! said = {"show_progress", "text", "printf (\"<%s>\", text);"};
%! text = evalc ("with_stand_ins (said, @() in_scratch (@(folder, scratch) check (folder)));");
%! assert (! isempty (strfind (text, "<2 of 4 points done, 1 failed"))); assert (text(end-1:end), "<>");
