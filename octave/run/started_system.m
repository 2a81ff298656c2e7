## -*- texinfo -*-
## @deftypefn {} {@var{system} =} started_system (@var{kind}, @var{scene}, @var{model})
## The system of a checked scene's @var{model} (see @code{kind_of}), which goes on from the end of another run of that
## scene where initial.from has its folder (see @code{end_before}).  An end of another number of coordinates, and one
## whose points were elsewhere, by more than rounding, are errors.
## @end deftypefn

function system = started_system (kind, scene, model)
  system = kind.system (scene, model);
  before = end_before (kind, scene);
  if (isempty (before))
    return;
  endif
  if (numel (before.state) != numel (system.initial_state))
    scene_error (["initial.from is \"%s\": that run ended with %d numbers of %s, this one begins with %d: take" ...
                  " the scene of that run, and state the modes that it had, or \"auto\", which takes chosen ones"], ...
                 before.folder, numel (before.state), before.model, numel (system.initial_state));
  endif
  system.initial_state = before.state;
  off = metres_off (kind, scene, model, system, before.points);
  if (off > 1e-6*norm (max (before.points) - min (before.points)))
    scene_error (["initial.from is \"%s\": points begin up to %.2g m away from where they ended in that run, of %s:" ...
                  " the rod, its modes, its stiffening, or what is prescribed at t = 0, are others; \"auto\" takes" ...
                  " its modes"], before.folder, off, ...
                 before.model);
  endif
endfunction

## the largest distance of the first points from those
function metres = metres_off (kind, scene, model, system, points)
  start = kind.observe (scene, model, system, 0, system.initial_state);
  ended = struct ("x", points(:,1), "y", points(:,2));
  if (columns (points) > 2)
    ended.z = points(:,3);
  endif
  metres = distance (start, ended);
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
%!function first = check_chosen (scene, folder)   # whose first half leaves its end in the folder
%!  first = setfield (scene, "duration", scene.duration/2);
%!  evalc ("result = driver (first, 'output', folder, 'pictures', false, 'exact', false);");
%!  first.initial.from = folder;
%!  rest = driver (first, "output", "", "exact", false);
%!  own = rest.rung;
%!  if (isfield (own, "basis"))
%!    own = rmfield (own, {"base", "basis"});
%!  endif
%!  assert (own, result.rung); assert (rest.summary.tried, []);
%!  whole = run_model (kind_of (scene), setfield (result.scene, "duration", scene.duration), result.model);
%!  assert ([rest.x(:,end); rest.y(:,end)], [whole.x(:,end); whole.y(:,end)], 1e-6);
%!endfunction
%!test # chosen modes are those of the rest, too; those of others are refused
%! [folder, gone] = scratch_folder ();
%! scene = setfield (setfield (large_swing (), "duration", 0.08), "solver", "tolerance", 1e-4);
%! check_chosen (scene, folder);
%! scene = chain (1);
%! scene.bodies{1}.model.modes = "auto";
%! scene.duration = 0.2;
%! check_chosen (scene, folder);
%! scene = struct ("rod", struct ("length", 0.4, "EA", 1e6, "EI", 4, "rhoA", 0.2), "duration", 0.1);
%! [scene.frames_per_second, scene.solver.tolerance, scene.moment] = deal (100, 1e-6, @(t) 0.5 + 0*t);
%! scene.model.energy = "uniaxial";
%! first = check_chosen (scene, folder);
%! fail ("driver (first, 'modes', [0, driver(first, 'output', '').rung.bending], 'output', '')", ...
%!       "points begin up to 0.00.* m away from where they ended in that run, of rod: .* bending modes");
%! fail ("driver (setfield (first, 'rod', 'length', 0.41), 'output', '')", "the rod, its modes, .* are others");
%! evalc ("ended = driver (rmfield (first, 'initial'), 'output', '', 'exact', false);");
%! over = driver (setfield (first, "moment", 0), "output", "");  # whose own modes would be others
%! assert ([over.x(:,1), over.y(:,1)], [ended.x(:,end), ended.y(:,end)], 1e-9);
