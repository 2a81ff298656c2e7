## -*- texinfo -*-
## @deftypefn {} {[@var{missing}, @var{warnings}] =} make_film (@var{frames}, @var{frames_per_second}, @var{folder})
## @file{animation.mp4} and @file{animation.gif} from the @var{frames} (a number) in @var{folder}.  What could not be
## made is in @var{missing} (n-by-2 cellstr), with the reason; @var{warnings} (cellstr) says which encoder stood in for
## another.
## @end deftypefn

function [missing, warnings] = make_film (frames, frames_per_second, folder)
  missing = cell (0, 2);
  warnings = {};
  if (system ("command -v ffmpeg > /dev/null") != 0)
    reason = "ffmpeg is not installed: `make setup` installs it";
    missing = {"animation.mp4", reason; "animation.gif", reason};
    return;
  endif
  [~, template] = frame_names ([], frames);
  source = sprintf ("ffmpeg -nostdin -loglevel error -y -framerate %.9g -i %s", frames_per_second, template);
  ## Browsers slow a gif of more than 50 frames a second down. Without dithering, what stands still costs nothing.
  filter = sprintf ("[0] fps=%.9g [f]; [f][1] paletteuse=dither=none:diff_mode=rectangle", ...
                    min (frames_per_second, 50));
  ## The colour bar is in every frame: a few have all colours.
  few = strjoin (frame_names (evenly_chosen (frames, 6), frames));
  gif = ["cat " few " | ffmpeg -loglevel error -y -f image2pipe -c:v png -i - -vf palettegen palette.png && " ...
         source " -i palette.png -filter_complex '" filter "' animation.gif"];
  job = start_tool (folder, "ffmpeg", gif);
  [encoder, why_not_mp4] = encode (folder, source);
  why_not_gif = finished (job, fullfile (folder, "animation.gif"));
  [~, ~] = unlink (fullfile (folder, "palette.png"));
  if (isempty (encoder))
    missing(end+1,:) = {"animation.mp4", why_not_mp4};
  elseif (! isempty (why_not_mp4))
    warnings = {sprintf(["animation.mp4 is encoded by %s, whose pictures are coarser and which not all players" ...
                         " show: %s; an ffmpeg with libx264 has the better film"], encoder, why_not_mp4)};
  endif
  if (! isempty (why_not_gif))
    missing(end+1,:) = {"animation.gif", why_not_gif};
    [~, ~] = unlink (fullfile (folder, "animation.gif"));
  endif
endfunction

## The first encoder that can, "" for none; and why it was not the first of all.
function [encoder, why] = encode (folder, source)
  encoders = {"libx264", "-preset veryfast -bf 0 -x264-params rc-lookahead=5 -crf 18"
              "libopenh264", "-b:v 6M"
              "mpeg4", "-q:v 2"};
  why = "";
  for row = encoders.'
    encoder = row{1};
    film = sprintf ("%s -c:v %s %s -pix_fmt yuv420p -movflags +faststart animation.mp4", source, row{:});
    failed = finished (start_tool (folder, "ffmpeg", film), fullfile (folder, "animation.mp4"));
    if (isempty (failed))
      return;
    elseif (isempty (why))
      why = failed;
    endif
  endfor
  encoder = "";
  [~, ~] = unlink (fullfile (folder, "animation.mp4"));
endfunction

## "" when a job ends well and its file is whole, else why not
function why = finished (job, file)
  why = "";
  try
    finish_tool (job);
    if (! is_whole (file))
      why = "cannot be written whole: is the disk full?";
    endif
  catch err
    why = strtrim (err.message);
  end_try_catch
endfunction

%!function [missing, warnings, there] = film_of (frames, refused)   # with an ffmpeg that refuses what matches
%!  [folder, gone] = scratch_folder (); mkdir (fullfile (folder, "bin")); mkdir (fullfile (folder, "scratch"));
%!  path = getenv ("PATH");
%!  unwind_protect
%!    finish_tools (draw_frames (setfield (sample_drawing (frames), "frame_size", [320 320]), ...
%!                               fullfile (folder, "scratch")));
%!    fake = fullfile (folder, "bin", "ffmpeg");
%!    write_text (fake, sprintf (["#!/bin/sh\nfor word; do case $word in %s) echo first >&2; " ...
%!                                "echo Unknown encoder $word >&2; exit 1;; esac; done\nexec %s \"$@\"\n"], ...
%!                               refused, nthargout (2, @system, "command -v ffmpeg")(1:end-1)));
%!    system (["chmod +x " fake]);
%!    setenv ("PATH", [fileparts(fake) ":" path]);
%!    [missing, warnings] = make_film (frames, 50, folder);
%!    there = cellfun (@(name) exist (fullfile (folder, name), "file") == 2, {"animation.mp4", "animation.gif"});
%!    assert (exist (fullfile (folder, "palette.png"), "file"), 0);
%!  unwind_protect_cleanup
%!    setenv ("PATH", path);
%!  end_unwind_protect
%!endfunction

%!testif ; system ("command -v ffmpeg > /dev/null") == 0
%! [missing, warnings, there] = film_of (3, "nothing");
%! assert (isempty (missing) && isempty (warnings) && all (there));
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # another encoder stands in for libx264, and it is said
%! [missing, warnings, there] = film_of (3, "libx264|libopenh264");
%! assert (isempty (missing) && all (there)); assert (numel (warnings), 1);
%! assert (! isempty (regexp (warnings{1}, "by mpeg4, .* ffmpeg failed with status 1: Unknown encoder libx264;")));
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # none: the gif is there
%! [missing, warnings, there] = film_of (3, "libx264|libopenh264|mpeg4");
%! assert (there, [false true]); assert (warnings, {});
%! assert (missing, {"animation.mp4", "ffmpeg failed with status 1: Unknown encoder libx264"});
%!testif ; system ("command -v ffmpeg > /dev/null") == 0 # neither
%! [missing, ~, there] = film_of (3, "-y");
%! assert (missing(:,1), {"animation.mp4"; "animation.gif"}); assert (there, [false false]);
%!test # without ffmpeg
%! path = getenv ("PATH");
%! unwind_protect
%!   setenv ("PATH", "/nowhere");
%!   missing = make_film (1, 50, tempdir ());
%!   assert (missing(:,1), {"animation.mp4"; "animation.gif"});
%!   assert (missing{2,2}, "ffmpeg is not installed: `make setup` installs it");
%! unwind_protect_cleanup
%!   setenv ("PATH", path);
%! end_unwind_protect
