## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} make_film (@var{frames_per_second}, @var{folder})
## @file{animation.mp4} and @file{animation.gif} from the frames in @var{folder}. Without ffmpeg there is no film but a
## text in the cell array @var{warnings}; it is an error when ffmpeg fails.
## @end deftypefn

function warnings = make_film (frames_per_second, folder)
  warnings = {};
  if (system ("command -v ffmpeg > /dev/null") != 0)
    warnings = {["animation.mp4 and animation.gif are missing, because ffmpeg is not installed: ", ...
                 "`make setup` installs it"]};
    return;
  endif
  source = sprintf ("ffmpeg -nostdin -loglevel error -y -framerate %.9g -i frames/frame_%%04d.png", frames_per_second);
  film = [source " -c:v libx264 -preset veryfast -pix_fmt yuv420p -crf 18 -movflags +faststart animation.mp4"];
  ## Browsers slow a gif of more than 50 frames a second down.
  filter = sprintf ("fps=%.9g, split [a][b]; [a] palettegen [p]; [b][p] paletteuse", min (frames_per_second, 50));
  gif = [source " -filter_complex '" filter "' animation.gif"];
  run_tool (folder, "ffmpeg", ["{ " gif " & } ; " film " ; made=$? ; wait $! && (exit $made)"]);
endfunction

%!test # without ffmpeg
%! path = getenv ("PATH");
%! unwind_protect
%!   setenv ("PATH", "/nowhere");
%!   warnings = make_film (50, tempdir ());
%!   assert (numel (warnings), 1);
%!   assert (! isempty (strfind (warnings{1}, "make setup")));
%! unwind_protect_cleanup
%!   setenv ("PATH", path);
%! end_unwind_protect
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # without frames
%! fail ("make_film (50, tempdir ())", "ffmpeg failed with status");
