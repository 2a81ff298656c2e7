## -*- texinfo -*-
## @deftypefn {} {@var{text} =} with_path (@var{data}, @var{frame}, @var{first}, @var{path}, @var{pieces})
## What a @var{frame} shows, @var{data} (frame, tip), in a share that begins with the frame @var{first}, with the
## tip's @var{path} (m-by-2) of so many @var{pieces} a frame (see @code{tip_path}).
##
## Each frame reads the path, and would take the longer the more there were of it: it comes as $tip_path with the
## first frame of a share and with each thousandth after it, from 3000 frames before.
## @end deftypefn

function text = with_path (data, frame, first, path, pieces)
  brought = frame - mod (frame - first, 1000);
  before = max (0, (brought - 1 - 3000)*pieces);
  text = data (frame, (frame - 1)*pieces - before);
  if (frame == brought)
    rows_to = min (rows (path), (frame + 999)*pieces + 1);
    text = [text, gnuplot_block("tip_path", {path(before + 1:rows_to,:)})];
  endif
endfunction

%!test # of a long run each frame has the path's row of its own time, and no more than 4000 before
%! data = @(frame, tip) sprintf ("tip = %d\n", tip);
%! path = (0:2*9999).'.*[1 1];
%! for first = [1 2001]
%!   for frame = [2001 2345 6100 7000]
%!     brought = with_path (data, frame - mod (frame - first, 1000), first, path, 2);
%!     rows_of = sscanf (brought(strfind (brought, "END")(1)+4:end), "%f");
%!     tip = sscanf (with_path (data, frame, first, path, 2), "tip = %d");
%!     assert (rows_of(2*tip+1), 2*(frame - 1));
%!     assert (numel (rows_of) <= 2*(2*4000 + 1));
%!   endfor
%! endfor
