## -*- texinfo -*-
## @deftypefn {} {[@dots{}] =} in_scratch (@var{use})
## What @var{use} (folder, scratch) returns, with a new folder and one named scratch in it, which are gone afterwards,
## whatever happens in them.
## @end deftypefn

function varargout = in_scratch (use)
  [folder, gone] = scratch_folder ();
  mkdir (fullfile (folder, "scratch"));
  [varargout{1:nargout}] = use (folder, fullfile (folder, "scratch"));
endfunction

%!test
%! [there, folder] = in_scratch (@(folder, scratch) deal (isfolder (scratch), folder));
%! assert (there); assert (! isfolder (folder));
%!error <in use> in_scratch (@(folder, scratch) error ("in use"))
