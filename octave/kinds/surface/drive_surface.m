## -*- texinfo -*-
## @deftypefn {} {@var{result} =} drive_surface (@var{scene}, @var{name}, @var{output}, @var{command})
## @code{driver} for a scene that has a surface: simulate the rod on it and leave history, summary, frames, film and
## figures where @var{output} (see @code{take_options}) says; @var{command} is what repeats it.  The result has the
## fields scene, system, history and summary.
## @end deftypefn

function result = drive_surface (scene, name, output, command = "")
  start = tic ();
  scene = check_surface_scene (scene);
  announce_breaks (scene.probed);
  if (isempty (scene.title))
    scene.title = name;
  endif
  prepare_output (output, scene);
  try
    [run, choice] = surface_run_of_scene (scene);
  catch err
    record_failure (output, name, scene, err);
    rethrow (err);
  end_try_catch
  announce (choice);
  [scene, system, history] = deal (run.scene, run.system, run.history);
  summary = summarise_surface (name, run, choice);
  summary.command = command;
  summary = write_run (output, scene, summary, start, @(file) write_surface_history (history, file), ...
                       @() surface_drawing (system, scene, history));
  result = struct ("scene", scene, "system", system, "history", history, "summary", summary);
endfunction

%!test # by the driver's name, without files
%! scene = setfield (large_swing (), "duration", 0.1);
%! result = driver (scene, "output", "", "modes", [5 5]);
%! assert (numel (result.history.t), 6);
%! assert (result.summary.largest_energy_error < 1e-7);
%!test # every file is there
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   said = evalc ("driver (setfield (bowl (), 'duration', 0.04), 'output', folder);");
%!   assert (! isempty (regexp (said, "estimated error: .* m, 0\\.\\d+ pixels")), said);
%!   for name = {"history.csv", "summary.json", "frames/frame_0003.png", "figure3.svg", "figure3.png", ...
%!               "figure3.pdf", "history.svg", "report.html"}
%!     assert (stat (fullfile (folder, name{1})).size > 300, name{1});
%!   endfor
%!   lines = strsplit (fileread (fullfile (folder, "history.csv")), "\n");
%!   assert (strncmp (lines{1}, "t [s],tip_x [m],tip_y [m],tip_z [m],alpha1_0,", 40));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
%!error <speed is not a field of a scene on a surface> driver (setfield (large_swing (), "speed", 1), "output", "")
