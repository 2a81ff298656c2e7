## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} frame_warnings (@var{scene})
## A cellstr: empty, or a warning that a checked @var{scene} has its last frame before the end of its duration, where
## the run ends (see @code{frame_times}), or no frame but that at its start.
## @end deftypefn

function warnings = frame_warnings (scene)
  warnings = {};
  times = frame_times (scene);
  rate = scene.frames_per_second;
  if (numel (times) == 1)
    warnings = {sprintf(["nothing moves: at %g frames a second the duration of %g s has one frame, at 0 s:" ...
                         " frames_per_second = %.3g has 100 more"], rate, scene.duration, 100/scene.duration)};
  elseif (scene.duration - times(end) > 1e-9*scene.duration)
    warnings = {sprintf(["the last frame is at %g s, before the duration of %g s: what follows it is not run," ...
                         " duration = %d/%.15g ends at a frame"], times(end), scene.duration, numel (times), rate)};
  endif
endfunction

%!function warnings = of_duration (duration, rate)
%!  warnings = frame_warnings (struct ("duration", duration, "frames_per_second", rate));
%!endfunction
%!assert (of_duration (0.2037, 200), {["the last frame is at 0.2 s, before the duration of 0.2037 s: what follows" ...
%!                                     " it is not run, duration = 41/200 ends at a frame"]})
%!assert (of_duration (0.005, 50), {["nothing moves: at 50 frames a second the duration of 0.005 s has one frame," ...
%!                                   " at 0 s: frames_per_second = 2e+04 has 100 more"]})
%!test # none where frames end with the duration, up to rounding, nor where what is said was done
%! for row = [1.8 50; 0.3 10; 41/200 200; 0.005 2e4; 1/3 3; 20/30 30; 0.1*3 10; 2/3*1.000000000001 30].'
%!   assert (of_duration (row(1), row(2)), {});
%! endfor
%!test # nor in the scenes that come along
%! for file = glob (fullfile (fileparts (which ("paper")), "*.m")).'
%!   [~, name] = fileparts (file{1});
%!   assert (frame_warnings (checked_scene (name, {})), {}, name);
%! endfor
