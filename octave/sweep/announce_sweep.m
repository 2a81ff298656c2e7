## -*- texinfo -*-
## @deftypefn {} {} announce_sweep (@var{plan}, @var{refused}, @var{to_do}, @var{engine}, @var{jobs})
## Say what a sweep of a @var{plan} (see @code{plan_sweep}) will do: how many points it has, how many of them are done
## already, are @var{refused} (cellstr), or run now, those @var{to_do}, by which @var{engine}, so many @var{jobs} at
## a time; what is another than in
## the last sweep in its folder; and what runs that are kept take of the disk.
## @end deftypefn

function announce_sweep (plan, refused, to_do, engine, jobs)
  say ("%d points of %s: %d done before, %d refused, %d to run by %s, %d at a time", numel (plan.keys), plan.typed, ...
       sum (plan.done), sum (! cellfun (@isempty, refused)), numel (to_do), engine, jobs);
  last = struct ();
  try
    last = jsondecode (fileread (fullfile (plan.folder, "sweep.json"))).about;
  catch  # there is none, or it is damaged
  end_try_catch
  words = struct ("program", "the program's sources", "scene", "the scene's file", ...
                  "options", "the scene or its options", "observe", "OBSERVE");
  for [text, name] = words
    if (isfield (last, name) && ! strcmp (last.(name), plan.about.(name)))
      say ("since the last sweep in %s %s changed: rows of before do not count", plan.folder, text);
    endif
  endfor
endfunction

%!function said = announced (folder, about, change)
%!  plan = struct ("keys", {{"a", "b", "c"}}, "typed", "swing", "done", [true false false], "folder", folder, ...
%!                 "about", about);
%!  write_summary (struct ("about", about), fullfile (folder, "sweep.json"));
%!  for pair = reshape (change, 2, [])
%!    plan.about.(pair{1}) = pair{2};
%!  endfor
%!  said = strrep (evalc ("announce_sweep (plan, {'', 'no', ''}, 3, 'make', 2);"), folder, "F");
%!endfunction
%!test
%! about = struct ("program", "1", "scene", "2", "options", "3", "observe", "4");
%! said = @(varargin) in_scratch (@(folder, scratch) announced (folder, about, varargin));
%! line = "3 points of swing: 1 done before, 1 refused, 1 to run by make, 2 at a time\n";
%! assert (said (), line);
%! changed = @(what) ["since the last sweep in F " what " changed: rows of before do not count\n"];
%! assert (said ("scene", "7"), [line, changed("the scene's file")]);
%! assert (said ("program", "7", "observe", "8"), [line, changed("the program's sources"), changed("OBSERVE")]);
