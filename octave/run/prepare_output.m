## -*- texinfo -*-
## @deftypefn {} {} prepare_output (@var{output}, @var{scene})
## What is to be known before the work of a run of the @var{scene}: whether the folder of @var{output} (see
## @code{take_options}) can be written and a dense table is not too long, errors where not, and what many pictures will
## cost.
## @end deftypefn

function prepare_output (output, scene)
  if (isempty (output.folder))
    return;
  endif
  [numbers, pictures] = run_files ();
  require_folder (output.folder, [numbers, pictures]);
  if (scene.duration*output.dense > 1e6)  # [] is not
    scene_error ("dense is %g: it makes %.3g rows in the duration of %g s, at most 1e6 of them are written", ...
                 output.dense, scene.duration*output.dense, scene.duration);
  endif
  frames = numel (frame_times (scene));
  [seconds, bytes] = picture_cost (frames, scene.frame_size);
  if (output.pictures && seconds > 60)
    say (["%d pictures will take some %s and %.2g GB, after the numbers are written: frames_per_second = %.2g" ...
          " would make 1000 of them, PICTURES=no none"], ...
         frames, clock_words (seconds), bytes/1e9, 1000/scene.duration);
  endif
endfunction

function text = clock_words (seconds)
  if (seconds < 5400)
    text = sprintf ("%.0f minutes", max (seconds/60, 2));
  else
    text = sprintf ("%.1f hours", seconds/3600);
  endif
endfunction

%!error <cannot be made|can be written>
%! prepare_output (struct ("folder", "/proc/nowhere", "pictures", true), struct ("duration", 1));
%!test # nothing is written without a folder
%! prepare_output (struct ("folder", "", "pictures", true), struct ());
%!test # what an hour of pictures costs is said, and how to have fewer; less, or none, goes without saying
%! [folder, gone] = scratch_folder ();
%! output = struct ("folder", folder, "pictures", true, "dense", []);
%! scene = struct ("duration", 3600, "frames_per_second", 50, "frame_size", [1280 720]);
%! said = evalc ("prepare_output (output, scene);");
%! expected = ["^180001 pictures will take some .* and 17 GB, after the numbers are written:" ...
%!             " frames_per_second = 0.28 would make 1000 of them, PICTURES=no none\n$"];
%! assert (! isempty (regexp (said, expected)), said);
%! for duration = [200 900 3600]
%!   scene.duration = duration;
%!   parts = regexp (evalc ("prepare_output (output, scene);"), 'some (\S+) (minutes|hours) ', "tokens"){1};
%!   seconds = picture_cost (numel (frame_times (scene)), scene.frame_size);
%!   unit = 60^(1 + strcmp (parts{2}, "hours"));
%!   assert (str2double (parts{1}), seconds/unit, max (0.5*60/unit, 0.05) + 1e-9);
%!   assert (strcmp (parts{2}, "hours"), seconds >= 5400);
%! endfor
%! assert (evalc ("prepare_output (setfield (output, 'pictures', false), scene);"), "");
%! assert (evalc ("prepare_output (output, setfield (scene, 'duration', 2));"), "");
%!test # a table that would be too long is refused before the run
%! [folder, gone] = scratch_folder ();
%! output = struct ("folder", folder, "pictures", false, "dense", 1e12);
%! scene = struct ("duration", 0.3, "frames_per_second", 50, "frame_size", [1280 720]);
%! fail ("prepare_output (output, scene)", "dense is 1e\\+12: it makes 3e\\+11 rows in the duration of 0.3 s, at");
%! prepare_output (setfield (output, "dense", 3e6), scene);
