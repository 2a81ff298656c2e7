## -*- texinfo -*-
## @deftypefn {} {@var{times} =} frame_times (@var{scene})
## The times of the frames, 1-by-m in s: from 0 in steps of 1/frames_per_second, the last one not after the duration.
## @end deftypefn

function times = frame_times (scene)
  times = (0:floor (scene.duration*scene.frames_per_second*(1 + 4*eps)))/scene.frames_per_second;
endfunction

%!assert (frame_times (struct ("duration", 1.8, "frames_per_second", 50))(end), 1.8)
%!assert (numel (frame_times (struct ("duration", 0.3, "frames_per_second", 10))), 4)
%!assert (frame_times (struct ("duration", 0.01, "frames_per_second", 50)), 0)
