## -*- texinfo -*-
## @deftypefn {} {} refuse_one_frame (@var{scene})
## An error where a checked @var{scene} has one frame alone: a study of its motions takes more.
## @end deftypefn

function refuse_one_frame (scene)
  if (numel (frame_times (scene)) < 2)
    scene_error ("duration is %g: the study takes more than one frame, at %g frames a second", scene.duration, ...
                 scene.frames_per_second);
  endif
endfunction

%!function study (name)
%!  name = str2func (name);
%!  name (setfield (swing (), "duration", 1e-3), "output", "");
%!endfunction
%!error <duration is 0.001: the study takes more than one frame, at 50> study ("model_ladder")
%!error <duration is 0.001: the study takes more than one frame> study ("work_precision")
%!error <duration is 0.001: the study takes more than one frame> study ("scene_stability")
%!test # what is at rest has no frames
%! evalc ("table = natural_modes (setfield (swing (), 'duration', 1e-3), 'modes', [0 1], 'output', '');");
%! assert (numel (table), 2);
