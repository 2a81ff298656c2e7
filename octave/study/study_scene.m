## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{kind}, @var{output}] =} study_scene (@var{which}, @var{options})
## The checked scene of a study, its kind (see @code{kind_of}) and where its files go: @var{which} and @var{options} (a
## cell array) are arguments as for @code{driver}.  A folder that cannot be written is an error.
## @end deftypefn

function [scene, kind, output] = study_scene (which, options)
  [scene, name] = load_scene (which);
  [scene, output] = take_options (scene, fullfile ("output", name), options);
  kind = kind_of (scene);
  scene = kind.check (scene);
  if (isempty (scene.title))
    scene.title = name;
  endif
  if (numel (frame_times (scene)) < 2)
    scene_error ("duration is %g: a study takes more than one frame, at %g frames a second", scene.duration, ...
                 scene.frames_per_second);
  endif
  require_folder (output.folder);
endfunction

%!error <cannot be made|can be written> study_scene ("paper", {"output", "/proc/nowhere"})
%!error <model.modes is "many": it takes> study_scene ("bowl", {"modes", "many"})
%!error <duration is 0.001: a study takes more than one frame> study_scene (setfield (swing (), "duration", 1e-3), {})
%!test
%! [scene, kind, output] = study_scene (swing (), {"output", tempdir(), "modes", [0 1]});
%! assert (scene.model.modes, [0 1]); assert (kind.name, "rod"); assert (output.folder, tempdir ());
