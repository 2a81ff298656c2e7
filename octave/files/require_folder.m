## -*- texinfo -*-
## @deftypefn {} {} require_folder (@var{folder})
## An error, before any work, where nothing can be written into @var{folder}, which is made where it is not there yet.
## @end deftypefn

function require_folder (folder)
  publish_run (folder, {}, @(aside) 0);
endfunction

%!error <the folder /proc/nowhere cannot be made: .|nothing can be written> require_folder ("/proc/nowhere")
%!test # a file of that name is none
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! write_text (file, "text");
%! fail ("require_folder (file)", "cannot be made");
