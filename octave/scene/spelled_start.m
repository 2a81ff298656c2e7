## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} spelled_start (@var{scene})
## A @var{scene}, not checked yet, whose initial = "equilibrium", or a folder of another run, is spelled out as
## initial.from.  A folder in which no run has left its end, and velocities beside it, are errors.
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
  for [value, name] = scene.initial
    moves = is_function_handle (value) || (isnumeric (value) && any (value));
    if (! isempty (from) && moves && ! isempty (regexp (name, '_dot$|^velocity$', "once")))
      scene_error ("initial.from and initial.%s are both given: what starts there has its velocities", name);
    endif
  endfor
  if (ischar (from) && ! any (strcmp (from, {"", "equilibrium"})) && exist (fullfile (from, "end.csv"), "file") != 2)
    scene_error (["initial.from is \"%s\": it takes \"equilibrium\", or a folder in which a run has left its" ...
                  " end.csv, output/paper say"], from);
  endif
endfunction

%!assert (spelled_start (struct ("initial", "equilibrium")).initial, struct ("from", "equilibrium"))
%!assert (spelled_start (struct ("duration", 1)), struct ("duration", 1))
%!error <initial.from is "nowhere": it takes "equilibrium", or a folder in which a run has left its end.csv>
%! spelled_start (struct ("initial", struct ("from", "nowhere")))
%!error <initial.from and initial.phi_dot are both given: what starts there has its velocities>
%! spelled_start (struct ("initial", struct ("from", "equilibrium", "phi_dot", 1)))
