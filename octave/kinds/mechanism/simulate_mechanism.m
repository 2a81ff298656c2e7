## -*- texinfo -*-
## @deftypefn {} {@var{result} =} simulate_mechanism (@var{scene}, @var{name}, @var{output}, @var{command})
## Simulate a @var{scene} of several bodies and leave history, summary and pictures where @var{output} (see
## @code{take_options}) says, as @code{driver} does for one rod; @var{command} is what repeats it.  @var{result} has
## the fields scene, mechanism, history and summary.
## @end deftypefn

function result = simulate_mechanism (scene, name, output, command = "")
  start = tic ();
  scene = check_mechanism (same_modes (scene));
  announce_breaks (scene.probed);
  scene.title = [scene.title, repmat(name, 1, isempty (scene.title))];
  scene.solver.tolerance = mechanism_tolerance (scene);
  prepare_output (output, scene);
  try
    [mechanism, choice] = mechanism_of_scene (scene);
    announce (choice);
    [history, count, warnings] = balanced_run (scene, mechanism, choice.trial);
  catch err
    record_failure (output, name, scene, err);
    rethrow (err);
  end_try_catch
  summary = summarise_mechanism (name, scene, mechanism, choice, count, history, warnings);
  summary.command = command;
  summary = write_run (output, scene, summary, start, ...
                       @(file) write_mechanism_history (scene, mechanism, history, file), ...
                       @() mechanism_drawing (scene, mechanism, history));
  result = struct ("scene", scene, "mechanism", mechanism, "history", history, "summary", summary);
endfunction

## the option "modes" is for all bodies
function scene = same_modes (scene)
  if (isfield (scene, "model") && isfield (scene.model, "modes"))
    if (isstruct (scene.bodies))
      scene.bodies = num2cell (scene.bodies);
    endif
    for k = 1:numel (scene.bodies)
      scene.bodies{k}.model.modes = scene.model.modes;
    endfor
    scene = rmfield (scene, "model");
  endif
endfunction

%!test # an arm is chosen, run and written; a second run in the same folder replaces it
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! scene = chain (2); scene.duration = 0.1;
%! unwind_protect
%!   evalc ("result = driver (scene, 'output', folder);");
%!   assert (result.summary.largest_constraint_residual < 1e-10);
%!   assert (result.summary.largest_constraint_velocity < 1e-8);
%!   assert (jsondecode (fileread (fullfile (folder, "summary.json"))).frames, 6);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
