## -*- texinfo -*-
## @deftypefn {} {} write_text (@var{file}, @var{text})
## Write @var{text} to @var{file}; it is an error when that fails.
## @end deftypefn

function write_text (file, text)
  [fid, message] = fopen (file, "w");
  if (fid < 0)
    error ("cannot write %s: %s", file, message);
  endif
  fputs (fid, text);
  fclose (fid);
endfunction

%!test
%! file = tempname ();
%! write_text (file, "a %d\n");
%! assert (fileread (file), "a %d\n");
%! delete (file);
%!error <cannot write .*no-folder/x>
%! write_text (fullfile (tempdir (), "no-folder", "x"), "");
