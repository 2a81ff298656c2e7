## -*- texinfo -*-
## @deftypefn {} {@var{times} =} frame_times (@var{scene})
## The times of the frames, 1-by-m in s: from 0 in steps of 1/frames_per_second, the last one not after the duration.
## @end deftypefn

function times = frame_times (scene)
  frames = scene.duration*scene.frames_per_second;
  if (frames > 1e6)
    scene_error ("frames_per_second is %g: it makes %.3g frames in the duration of %g s, at most 1e6 of them are run", ...
                 scene.frames_per_second, frames, scene.duration);
  endif
  times = (0:floor (scene.duration*scene.frames_per_second*(1 + 4*eps)))/scene.frames_per_second;
endfunction

%!assert (frame_times (struct ("duration", 1.8, "frames_per_second", 50))(end), 1.8)
%!assert (numel (frame_times (struct ("duration", 0.3, "frames_per_second", 10))), 4)
%!assert (frame_times (struct ("duration", 0.01, "frames_per_second", 50)), 0)
%!error <frames_per_second is 1e\+09: it makes 3e\+08 frames in the duration of 0.3 s, at most 1e6>
%! frame_times (struct ("duration", 0.3, "frames_per_second", 1e9));
