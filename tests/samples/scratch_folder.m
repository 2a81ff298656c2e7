## -*- texinfo -*-
## @deftypefn {} {[@var{folder}, @var{gone}] =} scratch_folder ()
## A new @var{folder}, which is removed with all that is in it when the variable @var{gone} goes: when the test or the
## function that has asked for it ends, whatever happens there.  Not for what ends with @code{lsode} in nested
## functions, which keeps variables of all its callers until it is called again.
## @end deftypefn

function [folder, gone] = scratch_folder ()
  folder = tempname ();
  mkdir (folder);
  gone = onCleanup (@() remove (folder));
endfunction

function remove (folder)
  confirm_recursive_rmdir (false, "local");
  rmdir (folder, "s");
endfunction

%!function fail_within ()
%!  [folder, gone] = scratch_folder ();
%!  write_text (fullfile (folder, "a"), "1");
%!  error ("within %s", folder);
%!endfunction
%!test # gone after a failure, too
%! try
%!   fail_within ();
%! catch err
%! end_try_catch
%! assert (! isfolder (regexp (err.message, "^within (.*)$", "tokens"){1}{1}));
%!test # another one in its place, as in a loop
%! [first, gone] = scratch_folder ();
%! [second, gone] = scratch_folder ();
%! assert (! isfolder (first)); assert (isfolder (second));
