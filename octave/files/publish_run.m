## -*- texinfo -*-
## @deftypefn {} {} publish_run (@var{folder}, @var{names}, @var{write})
## Make files whole or not at all: @var{write} (aside) writes into a folder of its own beside the final ones, and what
## it wrote is then moved to its place in @var{folder}.  An error in @var{write} leaves @var{folder} as it was.
##
## Of the @var{names} (cellstr) that a run can leave, those that this one did not write are removed: what is there
## belongs together.  A name like "frames/frame_*.png", where * stands for digits, is all such files of a folder.
## Other files in @var{folder}, and in such folders, are not touched, but for what runs that were killed left there; a
## folder with files in it in the place of one of the @var{names} is an error.
## @end deftypefn

function publish_run (folder, names, write)
  [made, message] = mkdir (folder);
  if (! made)
    scene_error ("the folder %s cannot be made: %s", folder, message);
  endif
  refuse_foreign (folder, names);
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
      [within, base, extension] = fileparts (name{1});
      if (isempty (within))
        replace (fullfile (aside, name{1}), fullfile (folder, name{1}), aside);
      else
        replace_within (fullfile (aside, within), fullfile (folder, within), [base extension], aside);
      endif
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

## the files like the pattern, one by one where others are beside them, else the whole folder
function replace_within (new, old, pattern, aside)
  [others, own] = foreign_files (old, pattern);
  if (isempty (others))
    replace (new, old, aside);
  else
    cellfun (@(name) replace ("", fullfile (old, name), aside), own);
    [~, written] = foreign_files (new, pattern);
    cellfun (@(name) replace (fullfile (new, name), fullfile (old, name), aside), written);
  endif
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
%!function publish_frames (folder)
%!  file = @(name) fullfile (folder, "frames", name);
%!  frames = @(aside, names) [mkdir(fullfile (aside, "frames")), ...
%!                            cellfun(@(name) leave_one (fullfile (aside, "frames", name)), names)];
%!  publish = @(names) publish_run (folder, {"frames/frame_*.png"}, @(aside) frames (aside, names));
%!  publish ({"frame_1.png", "frame_2.png"});
%!  publish ({"frame_3.png"});
%!  assert (readdir (file ("")), {".", "..", "frame_3.png"}.');
%!  leave (file ("mine.png"), "my own"); mkdir (file ("more")); leave (file ("more/frame_1.png"), "my own");
%!  publish ({"frame_1.png", "frame_2.png"});
%!  assert (readdir (file ("")), {".", "..", "frame_1.png", "frame_2.png", "mine.png", "more"}.');
%!  publish_run (folder, {"frames/frame_*.png"}, @(aside) 0);
%!  assert (readdir (file ("")), {".", "..", "mine.png", "more"}.');
%!  assert (fileread (file ("more/frame_1.png")), "my own");
%!endfunction
%!function one = leave_one (file)
%!  leave (file, "1");
%!  one = 1;
%!endfunction
%!test # of a folder of frames only these go
%! in_scratch (@(folder, scratch) publish_frames (scratch));
%!function publish_over (folder)
%!  mkdir (fullfile (folder, "b"));
%!  leave (fullfile (folder, "a"), "1"); leave (fullfile (folder, "b", "own"), "own");
%!  fail ("publish_run (folder, {'a', 'b'}, @(aside) leave (fullfile (aside, 'b'), '2'))", "b is a folder with files");
%!  assert (fileread (fullfile (folder, "a")), "1"); assert (fileread (fullfile (folder, "b", "own")), "own");
%!endfunction
%!test # a folder with files in the place of a file is refused before anything is lost
%! in_scratch (@(folder, scratch) publish_over (scratch));
%!error <cannot be made|can be written> publish_run ("/proc/nowhere", {}, @(aside) 0)
