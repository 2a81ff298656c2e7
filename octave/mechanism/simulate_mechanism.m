## -*- texinfo -*-
## @deftypefn {} {@var{result} =} simulate_mechanism (@var{scene}, @var{name}, @var{folder}, @var{command})
## Simulate a @var{scene} of several bodies and leave history, summary and pictures in @var{folder} ("": none), as
## @code{driver} does for one rod; @var{command} is what repeats it.  @var{result} has the fields scene,
## mechanism, history and summary.
## @end deftypefn

function result = simulate_mechanism (scene, name, folder, command = "")
  start = tic ();
  scene = check_mechanism (same_modes (scene));
  scene.title = [scene.title, repmat(name, 1, isempty (scene.title))];
  scene.solver.tolerance = mechanism_tolerance (scene);
  try
    [mechanism, choice] = choose_mechanism (scene);
    announce_levels (choice);
    [history, count, warnings] = balanced_run (scene, mechanism, choice.trial);
  catch err
    if (strcmp (err.identifier, "toolchain:integration") && ! isempty (folder))
      record_failure (folder, name, scene, err.message);
    endif
    rethrow (err);
  end_try_catch
  summary = summarise_mechanism (name, scene, mechanism, choice, count, history, warnings);
  summary.command = command;
  if (! isempty (folder))
    summary = write_run (folder, scene, summary, start, ...
                         @(file) write_mechanism_history (scene, mechanism, history, file), ...
                         @() mechanism_drawing (scene, mechanism, history));
  endif
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
%!   evalc ("result = simulate_mechanism (scene, \"chain\", folder);");
%!   assert (result.summary.largest_constraint_residual < 1e-10);
%!   assert (result.summary.largest_constraint_velocity < 1e-8);
%!   assert (jsondecode (fileread (fullfile (folder, "summary.json"))).frames, 6);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
