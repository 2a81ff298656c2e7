## -*- texinfo -*-
## @deftypefn {} {} refuse_foreign (@var{folder}, @var{names})
## An error where a folder that is not empty has one of the @var{names} (cellstr, see @code{publish_run}) of the files
## that are to be written into @var{folder}: what is in it would be lost.
## @end deftypefn

function refuse_foreign (folder, names)
  for name = names(cellfun (@isempty, strfind (names, "/")))
    path = fullfile (folder, name{1});
    if (! isempty (foreign_files (path, "")))
      scene_error ("%s is a folder with files in it, where a file is to be written: move it, or take another OUTPUT", ...
                   path);
    endif
  endfor
endfunction

%!test # a folder of an own name, with something in it
%! [folder, gone] = scratch_folder ();
%! own = fullfile (folder, "history.csv");
%! mkdir (own);
%! refuse_foreign (folder, {"history.csv", "frames/frame_*.png"});
%! write_text (fullfile (own, "mine"), "text");
%! refuse_foreign (folder, {"summary.json"});
%! fail ("refuse_foreign (folder, {'summary.json', 'history.csv'})", "history.csv is a folder with files in it");
