## -*- texinfo -*-
## @deftypefn {} {@var{quoted} =} gnuplot_string (@var{text})
## @var{text} as a string of gnuplot, on one line, without characters that control something.  It is put together of
## what stands between its apostrophes: gnuplot takes a doubled one for the end of a string that begins with it.
## @end deftypefn

function quoted = gnuplot_string (text)
  quoted = ["'" strrep(regexprep (text, '[\s[:cntrl:]]', " "), "'", "'.\"'\".'") "'"];
endfunction

%!assert (gnuplot_string ("it's"), "'it'.\"'\".'s'")
%!test # gnuplot reads the text back
%! text = "''it's \"a_b\" `x` $y \\n 100 %'\\";
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! fid = fopen (file, "w");
%! fprintf (fid, "set print '-'; print %s", gnuplot_string (text));
%! fclose (fid);
%! [~, said] = system (["gnuplot " file]);
%! assert (said, [text "\n"]);
