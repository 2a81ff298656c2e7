## -*- texinfo -*-
## @deftypefn {} {@var{whole} =} is_whole (@var{file})
## Whether a picture or a film is there and ends as files of its kind do: on a full disk gnuplot and ffmpeg may end
## without an error.
## @end deftypefn

function whole = is_whole (file)
  ends = struct ("png", ["IEND", char([174, 66, 96, 130])], "svg", "</svg>", "pdf", "%%EOF", "gif", ";");
  [~, ~, kind] = fileparts (file);
  id = fopen (file, "r");
  if (id < 0)
    whole = false;
    return;
  endif
  bytes = stat (file).size;
  if (strcmp (kind, ".mp4"))
    whole = boxes_fit (id, bytes);
  else
    fseek (id, -min (12, bytes), SEEK_END ());
    tail = fread (id, Inf, "uint8=>char").';
    whole = ! isempty (strfind (tail, ends.(kind(2:end))));
  endif
  fclose (id);
endfunction

## An MP4 file is a row of boxes of known sizes: one is the index, moov, and one has the pictures, mdat.
function whole = boxes_fit (id, bytes)
  place = 0;
  kinds = {};
  while (place + 8 <= bytes)
    fseek (id, place, SEEK_SET ());
    box = fread (id, 1, "uint32", 0, "ieee-be");
    kinds{end+1} = fread (id, 4, "uint8=>char").';
    if (box == 1)
      box = fread (id, 1, "uint64", 0, "ieee-be");
    endif
    place += max (box, 8);
  endwhile
  whole = place == bytes && all (ismember ({"moov", "mdat"}, kinds));
endfunction

%!assert (is_whole ("/nowhere.png"), false)
%!function whole = is_kept (file, text)
%!  write_text (file, text);
%!  whole = is_whole (file);
%!endfunction
%!function check_drawing (file)
%!  assert (is_kept (file, ""), false);
%!  assert (is_kept (file, "<svg>"), false);
%!  assert (is_kept (file, "<svg>\n</svg>\n\n"));
%!endfunction
%!test in_scratch (@(folder, scratch) check_drawing (fullfile (folder, "a.svg")));
%!function check_film (file)
%!  system (["ffmpeg -nostdin -loglevel error -f lavfi -i testsrc=d=0.5:s=320x320 -c:v mpeg4 " file]);
%!  assert (is_whole (file));
%!  assert (is_kept (file, fileread (file)(1:end-1)), false);
%!endfunction
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # a film, and one that is cut
%! in_scratch (@(folder, scratch) check_film (fullfile (folder, "a.mp4")));
