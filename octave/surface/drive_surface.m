## -*- texinfo -*-
## @deftypefn {} {@var{result} =} drive_surface (@var{scene}, @var{name}, @var{options})
## @code{driver} for a scene that has a surface: simulate the rod on it and leave history, summary, frames, film and
## figures.  The result has the fields scene, system, history and summary.
## @end deftypefn

function result = drive_surface (scene, name, options)
  start = tic ();
  [scene, folder] = take_options (scene, fullfile ("output", name), options);
  scene = check_surface_scene (scene);
  if (isempty (scene.title))
    scene.title = name;
  endif
  system = surface_rod (scene);
  try
    [history, count] = run_surface (system, scene);
  catch err
    if (strcmp (err.identifier, "toolchain:integration") && ! isempty (folder))
      record_failure (folder, name, scene, err.message);
    endif
    rethrow (err);
  end_try_catch
  summary = summarise_surface (name, scene, history, count);
  if (! isempty (folder))
    summary = write_surface_run (folder, system, scene, history, summary, start);
  endif
  result = struct ("scene", scene, "system", system, "history", history, "summary", summary);
endfunction

%!test # by the driver's name, without files
%! scene = setfield (large_swing (), "duration", 0.1);
%! result = driver (scene, "output", "", "modes", [5 5]);
%! assert (numel (result.history.t), 6);
%! assert (result.summary.largest_energy_error < 1e-7);
%!error <speed is not a field of a scene on a surface> driver (setfield (large_swing (), "speed", 1), "output", "")
