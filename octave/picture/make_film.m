## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} make_film (@var{frames}, @var{frames_per_second}, @var{folder})
## @file{animation.mp4} and @file{animation.gif}, made at once, from the @var{frames} (a number) in @var{folder}.
## Without ffmpeg there is no film but a text in the cell array @var{warnings}; it is an error when ffmpeg fails.
## @end deftypefn

function warnings = make_film (frames, frames_per_second, folder)
  warnings = {};
  if (system ("command -v ffmpeg > /dev/null") != 0)
    warnings = {["animation.mp4 and animation.gif are missing, because ffmpeg is not installed: ", ...
                 "`make setup` installs it"]};
    return;
  endif
  ## The colour bar is in every frame: a few have all colours.
  few = sprintf ("frames/frame_%04d.png ", unique (round (linspace (1, frames, 6))));
  run_tool (folder, "ffmpeg", ["cat " few "| ffmpeg -loglevel error -y -f image2pipe -c:v png -i -" ...
                               " -vf palettegen palette.png"]);
  source = sprintf ("ffmpeg -nostdin -loglevel error -y -framerate %.9g -i frames/frame_%%04d.png", frames_per_second);
  film = [source " -c:v libx264 -preset veryfast -bf 0 -x264-params rc-lookahead=5 -pix_fmt yuv420p -crf 18" ...
          " -movflags +faststart animation.mp4"];
  ## Browsers slow a gif of more than 50 frames a second down. Without dithering, what stands still costs nothing.
  filter = sprintf ("[0] fps=%.9g [f]; [f][1] paletteuse=dither=none:diff_mode=rectangle", ...
                    min (frames_per_second, 50));
  gif = [source " -i palette.png -filter_complex '" filter "' animation.gif"];
  jobs = [start_tool(folder, "ffmpeg", film), start_tool(folder, "ffmpeg", gif)];
  arrayfun (@finish_tool, jobs);
  unlink (fullfile (folder, "palette.png"));
  require_whole (fullfile (folder, "animation.gif"));
endfunction

%!test # without ffmpeg
%! path = getenv ("PATH");
%! unwind_protect
%!   setenv ("PATH", "/nowhere");
%!   warnings = make_film (1, 50, tempdir ());
%!   assert (numel (warnings), 1);
%!   assert (! isempty (strfind (warnings{1}, "make setup")));
%! unwind_protect_cleanup
%!   setenv ("PATH", path);
%! end_unwind_protect
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # without frames
%! fail ("make_film (1, 50, tempdir ())", "ffmpeg failed with status");
