## -*- texinfo -*-
## @deftypefn {} {} require_whole (@var{file})
## It is an error when a picture does not end as files of its kind do: gnuplot ends well on a full disk.
## @end deftypefn

function require_whole (file)
  ends = struct ("png", ["IEND", char([174, 66, 96, 130])], "svg", "</svg>", "pdf", "%%EOF", "gif", ";");
  [~, ~, kind] = fileparts (file);
  id = fopen (file, "r");
  whole = id >= 0;
  if (whole)
    fseek (id, -min (12, stat (file).size), SEEK_END ());
    tail = fread (id, Inf, "uint8=>char").';
    whole = ! isempty (strfind (tail, ends.(kind(2:end))));
    fclose (id);
  endif
  if (! whole)
    scene_error ("%s is not whole: is the disk full?", file);
  endif
endfunction

%!error <nowhere.png is not whole> require_whole ("/nowhere.png")
%!test
%! file = [tempname() ".svg"];
%! unwind_protect
%!   write_text (file, "<svg>");
%!   fail ("require_whole (file)", "is the disk full");
%!   write_text (file, "<svg>\n</svg>\n\n");
%!   require_whole (file);
%! unwind_protect_cleanup
%!   unlink (file);
%! end_unwind_protect
