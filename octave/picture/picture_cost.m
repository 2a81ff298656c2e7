## -*- texinfo -*-
## @deftypefn {} {[@var{seconds}, @var{bytes}] =} picture_cost (@var{frames}, @var{frame_size})
## What so many @var{frames} of the @var{frame_size} (pixels) cost, with film and gif: @var{seconds} of the clock with
## this machine's processors to themselves, and @var{bytes} of the disk while they are drawn.
##
## Measured on the 91 frames of 1280 by 720 of the scene paper: seconds of a processor by `time' on gnuplot (2.9) and
## on both calls of ffmpeg (2.5), bytes by `du' on frames (6.8e6), their data (1.2e6), film and gif (0.7e6).
## @end deftypefn

function [seconds, bytes] = picture_cost (frames, frame_size)
  times_as_many = frames/91*prod (frame_size)/(1280*720);
  seconds = times_as_many*(2.9/nproc () + 2.5/min (nproc (), 2));
  bytes = times_as_many*(6.8e6 + 1.2e6 + 0.7e6);
endfunction

%!test # an hour at 50 frames a second: 60 ms of a processor a frame and 17 GB
%! [seconds, bytes] = picture_cost (180001, [1280 720]);
%! assert (seconds*nproc (), 180001/91*(2.9 + 2.5*max (1, nproc ()/2)), 1e-6*seconds); assert (bytes, 17.2e9, 0.1e9);
%! assert (picture_cost (100, [2560 1440]), 4*picture_cost (100, [1280 720]), 1e-9);
%!function on_eight ()
%!  assert (picture_cost (91, [1280 720]), 2.9/8 + 2.5/2, 1e-12);
%!endfunction
%!test # of eight processors frames take all, and the film two
%! with_stand_ins ({"count = nproc", "varargin", "count = 8;"}, @on_eight);
