## -*- texinfo -*-
## @deftypefn {} {} with_stand_ins (@var{stand_ins}, @var{call})
## Run the function @var{call} while other functions have stand-ins: @var{stand_ins} is a cell array, a row each, of
## name, arguments and body, "function NAME (ARGUMENTS)" as the name has it.  So the long way of a study can be seen
## from beginning to end without what takes it long.
## @end deftypefn

function with_stand_ins (stand_ins, call)
  folder = tempname ();
  mkdir (folder);
  before = path ();
  shadowed = warning ("off", "Octave:shadowed-function");
  unwind_protect
    for row = stand_ins.'
      name = regexp (row{1}, '\w+$', "match", "once");
      write_text (fullfile (folder, [name ".m"]), sprintf ("function %s (%s)\n%s\nendfunction\n", row{:}));
    endfor
    addpath (folder);
    call ();
  unwind_protect_cleanup
    path (before);
    warning (shadowed);
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
endfunction

%!function call_it (folder)
%!  write_text (fullfile (folder, "gave"), rung_label (3));
%!endfunction
%!test # a stand-in, and then the function again, which takes no number
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   with_stand_ins ({"text = rung_label", "rung", "text = sprintf (\"<%d>\", rung);"}, @() call_it (folder));
%!   assert (fileread (fullfile (folder, "gave")), "<3>");
%!   fail ("call_it (folder)");
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
