## -*- texinfo -*-
## @deftypefn {} {} publish_run (@var{folder}, @var{names}, @var{write})
## Make files whole or not at all: @var{write} (aside) writes into a folder of its own beside the final ones, and what
## it wrote is then moved to its place in @var{folder}.  An error in @var{write} leaves @var{folder} as it was.
##
## Of the @var{names} (cellstr) that a run can leave, those that this one did not write are removed: what is there
## belongs together.  Other files in @var{folder} are not touched, but for what runs that were killed left there.
## @end deftypefn

function publish_run (folder, names, write)
  [made, message] = mkdir (folder);
  if (! made)
    scene_error ("the folder %s cannot be made: %s", folder, message);
  endif
  confirm_recursive_rmdir (false, "local");
  remove_left_over (folder);
  aside = tempname (folder, sprintf (".partial-%d-", getpid ()));
  [made, message] = mkdir (aside);
  if (! made)
    scene_error ("nothing can be written into %s: %s", folder, message);
  endif
  unwind_protect
    write (aside);
    for name = names
      replace (fullfile (aside, name{1}), fullfile (folder, name{1}), aside);
    endfor
  unwind_protect_cleanup
    rmdir (aside, "s");
  end_unwind_protect
endfunction

## the folders of processes that are no more
function remove_left_over (folder)
  names = readdir (folder);
  for left = names(strncmp (names, ".partial-", 9)).'
    process = regexp (left{1}, '^\.partial-(\d+)-\w+$', "tokens");
    if (! isempty (process) && kill (str2double (process{1}{1}), 0) != 0)
      rmdir (fullfile (folder, left{1}), "s");
    endif
  endfor
endfunction

## Folders cannot be written over: the old one steps aside.
function replace (new, old, aside)
  is_new = exist (new);
  if (isfolder (old) || (exist (old, "file") && ! is_new))
    rename (old, tempname (aside, "old-"));
  endif
  if (is_new)
    [status, message] = rename (new, old);
    if (status != 0)
      scene_error ("%s cannot be written: %s", old, message);
    endif
  endif
endfunction

%!function leave (file, text)
%!  fid = fopen (file, "w"); fputs (fid, text); fclose (fid);
%!endfunction

%!function publish_thrice (folder)
%!  leave (fullfile (folder, "own.txt"), "own");
%!  publish_run (folder, {"a", "b"}, @(aside) cellfun (@(name) leave (fullfile (aside, name), "1"), {"a", "b"}));
%!  try, publish_run (folder, {"a", "b"}, @(aside) error ("no")); catch, end_try_catch
%!  assert (fileread (fullfile (folder, "b")), "1");
%!  publish_run (folder, {"a", "b"}, @(aside) leave (fullfile (aside, "a"), "2"));
%!  assert (fileread (fullfile (folder, "a")), "2");
%!  assert (sort ({dir(folder).name}), {".", "..", "a", "own.txt"});
%!endfunction
%!test # a run that fails leaves the last one; one that succeeds removes what it did not write
%! in_scratch (@(folder, scratch) publish_thrice (scratch));
%!function publish_beside_others (folder)
%!  gone = fullfile (folder, ".partial-99999999-abcdef"); mkdir (gone);
%!  alive = fullfile (folder, sprintf (".partial-%d-abcdef", getpid ())); mkdir (alive);
%!  publish_run (folder, {}, @(aside) 0);
%!  assert ([isfolder(gone), isfolder(alive)], [false, true]);
%!endfunction
%!test # what a killed run has left goes, what a living one writes stays
%! in_scratch (@(folder, scratch) publish_beside_others (scratch));
%!error <cannot be made|can be written> publish_run ("/proc/nowhere", {}, @(aside) 0)
