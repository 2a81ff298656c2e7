## -*- texinfo -*-
## @deftypefn {} {} prepare_output (@var{output}, @var{scene})
## What is to be known before the work of a run of the @var{scene}: whether the folder of @var{output} (see
## @code{take_options}) can be written, which is an error where it cannot, and what many pictures will cost.
## @end deftypefn

function prepare_output (output, scene)
  if (isempty (output.folder))
    return;
  endif
  require_folder (output.folder);
endfunction

%!error <cannot be made|can be written>
%! prepare_output (struct ("folder", "/proc/nowhere", "pictures", true), struct ("duration", 1));
%!test prepare_output (struct ("folder", "", "pictures", true), struct ());
