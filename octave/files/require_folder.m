## -*- texinfo -*-
## @deftypefn {} {} require_folder (@var{folder}, @var{names})
## An error, before any work, where nothing can be written into @var{folder}, which is made where it is not there yet,
## or where folders with files in them have @var{names} (see @code{refuse_foreign}) that are to be written.
## @end deftypefn

function require_folder (folder, names = {})
  publish_run (folder, {}, @(aside) 0);
  refuse_foreign (folder, names);
endfunction

%!error <the folder /proc/nowhere cannot be made: .|nothing can be written> require_folder ("/proc/nowhere")
%!test # a file of that name is none
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! write_text (file, "text");
%! fail ("require_folder (file)", "cannot be made");
%!test # nor may a folder be where a file is to be
%! [folder, gone] = scratch_folder ();
%! mkdir (fullfile (folder, "a.csv")); write_text (fullfile (folder, "a.csv", "mine"), "text");
%! require_folder (folder, {"b.csv"});
%! fail ("require_folder (folder, {'a.csv'})", "a.csv is a folder with files in it");
