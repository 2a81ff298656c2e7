## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} spelled_start (@var{scene})
## A @var{scene}, not checked yet, whose initial = "equilibrium", or a folder of another run, is spelled out as
## initial.from.  A folder in which no run has left its end is an error.
## @end deftypefn

function scene = spelled_start (scene)
  if (! (isstruct (scene) && isscalar (scene) && isfield (scene, "initial")))
    return;
  endif
  if (ischar (scene.initial))
    scene.initial = struct ("from", scene.initial);
  endif
  if (! (isstruct (scene.initial) && isfield (scene.initial, "from")))
    return;
  endif
  from = scene.initial.from;
  if (ischar (from) && ! any (strcmp (from, {"", "equilibrium"})) && exist (fullfile (from, "end.csv"), "file") != 2)
    scene_error (["initial.from is \"%s\": it takes \"equilibrium\", or a folder in which a run has left its" ...
                  " end.csv, output/paper say"], from);
  endif
endfunction

%!assert (spelled_start (struct ("initial", "equilibrium")).initial, struct ("from", "equilibrium"))
%!assert (spelled_start (struct ("duration", 1)), struct ("duration", 1))
%!error <initial.from is "nowhere": it takes "equilibrium", or a folder in which a run has left its end.csv>
%! spelled_start (struct ("initial", struct ("from", "nowhere")))
