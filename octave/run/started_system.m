## -*- texinfo -*-
## @deftypefn {} {@var{system} =} started_system (@var{kind}, @var{scene}, @var{model})
## The system of a checked scene's @var{model} (see @code{kind_of}), which goes on from the end of another run of that
## scene where initial.from has its folder (see @code{write_end}).  An end of another kind, or of another number of
## coordinates, is an error.
## @end deftypefn

function system = started_system (kind, scene, model)
  system = kind.system (scene, model);
  if (! (isfield (scene, "initial") && isfield (scene.initial, "from"))
      || any (strcmp (scene.initial.from, {"", "equilibrium"})))
    return;
  endif
  folder = scene.initial.from;
  lines = strsplit (strtrim (fileread (fullfile (folder, "end.csv"))), "\n");
  state = str2double (lines(2:end)(:));
  words = strsplit (lines{1}, ": ");
  if (! strcmp (words{1}, kind.name) || numel (state) != numel (system.initial_state))
    scene_error (["initial.from is \"%s\": that run ended with %d numbers of %s, this one begins with %d of the" ...
                  " kind \"%s\"; state the modes that it had, MODES=\"0 6\" say"], folder, numel (state), lines{1}, ...
                 numel (system.initial_state), kind.name);
  endif
  system.initial_state = state;
endfunction

%!function check (scene, tolerance)   # half of a run and the rest of it are the whole
%!  [folder, gone] = scratch_folder ();
%!  whole = driver (scene, "output", "");
%!  first = setfield (scene, "duration", scene.duration/2);
%!  evalc ("driver (first, 'output', folder, 'pictures', false);");
%!  rest = driver (setfield (first, "initial", "from", folder), "output", "");
%!  assert ([rest.x(:,end); rest.y(:,end)], [whole.x(:,end); whole.y(:,end)], tolerance);
%!  fail ("driver (setfield (first, 'initial', folder), 'output', '', 'modes', [4 6])", "state the modes that it");
%!endfunction
%!test # of every kind
%! scene = setfield (setfield (slender (), "model", "modes", [0 2]), "solver", "tolerance", 1e-8);
%! scene.duration = 0.4;
%! [scene.moment, scene.moment_breaks] = deal (0, []);
%! check (scene, 1e-7);
%! scene = chain (1);
%! [scene.duration, scene.solver.tolerance] = deal (0.4, 1e-8);
%! check (scene, 1e-7);
%! scene = setfield (setfield (large_swing (), "model", "modes", [4 4]), "solver", "tolerance", 1e-8);
%! scene.duration = 0.2;
%! check (scene, 1e-7);
