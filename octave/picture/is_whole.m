## -*- texinfo -*-
## @deftypefn {} {@var{whole} =} is_whole (@var{file})
## Whether a picture is there and ends as files of its kind do: gnuplot ends well on a full disk.
## @end deftypefn

function whole = is_whole (file)
  ends = struct ("png", ["IEND", char([174, 66, 96, 130])], "svg", "</svg>", "pdf", "%%EOF", "gif", ";", "mp4", "");
  [~, ~, kind] = fileparts (file);
  id = fopen (file, "r");
  whole = id >= 0 && stat (file).size > 0;
  if (whole)
    fseek (id, -min (12, stat (file).size), SEEK_END ());
    tail = fread (id, Inf, "uint8=>char").';
    ending = ends.(kind(2:end));
    whole = isempty (ending) || ! isempty (strfind (tail, ending));
  endif
  if (id >= 0)
    fclose (id);
  endif
endfunction

%!assert (is_whole ("/nowhere.png"), false)
%!test
%! file = [tempname() ".svg"];
%! unwind_protect
%!   write_text (file, "");
%!   assert (is_whole (file), false);
%!   write_text (file, "<svg>");
%!   assert (is_whole (file), false);
%!   write_text (file, "<svg>\n</svg>\n\n");
%!   assert (is_whole (file));
%! unwind_protect_cleanup
%!   unlink (file);
%! end_unwind_protect
