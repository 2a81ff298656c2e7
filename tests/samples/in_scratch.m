## -*- texinfo -*-
## @deftypefn {} {[@dots{}] =} in_scratch (@var{use})
## What @var{use} (folder, scratch) returns, with a new folder and one named scratch in it, which are gone afterwards,
## whatever happens in them.
## @end deftypefn

function varargout = in_scratch (use)
  folder = tempname ();
  mkdir (folder);
  mkdir (fullfile (folder, "scratch"));
  unwind_protect
    [varargout{1:nargout}] = use (folder, fullfile (folder, "scratch"));
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
endfunction

%!test
%! [there, folder] = in_scratch (@(folder, scratch) deal (isfolder (scratch), folder));
%! assert (there); assert (! isfolder (folder));
%!error <in use> in_scratch (@(folder, scratch) error ("in use"))
