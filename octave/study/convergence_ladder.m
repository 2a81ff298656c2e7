## -*- texinfo -*-
## @deftypefn {} {[@var{table}, @var{scene}] =} convergence_ladder (@var{scene}, @var{folder})
## The convergence of a mechanism or a curved rod in its modes: centrelines with N1 + N2 modes a rod against those with
## the most, at a fiftieth of the scene's tolerance.  Prints a table; @var{table} is like that of @code{model_ladder},
## and the @var{scene} comes back checked.  It is an error, before the work, where the @var{folder} cannot be written.
## @end deftypefn

function [table, scene] = convergence_ladder (scene, folder)
  if (isfield (scene, "bodies"))
    [trial, sizes, scene] = mechanism_trials (scene);
  else
    [trial, sizes, scene] = curved_trials (scene);
  endif
  require_folder (folder);
  trials = cellfun (trial, sizes, "uniformoutput", false);
  table = struct ([]);
  for k = 1:numel (sizes) - 1
    t = trials{k};
    error_m = distance (t, trials{end});
    label = sprintf ("%d+%d", sizes{k});
    table = [table, struct("model", [label " modes"], "method", t.count.method, "error_m", error_m, ...
                           "seconds", t.count.seconds, "calls", t.count.calls, "label", label, ...
                           "stiffening", "none", "chosen", false, "extrapolated", false)];
    printf ("  %-10s %10.3g m %8.2f s, tip of the last rod at the end %.8f %.8f m\n", label, error_m, ...
            t.count.seconds, t.x(end,end), t.y(end,end));
  endfor
endfunction

function [trial, sizes, scene] = mechanism_trials (scene)
  scene = check_mechanism (scene);
  fine = setfield (scene, "solver", "tolerance", scene.solver.tolerance/50);
  sizes = {[0 0], [0 1], [0 2], [1 3], [2 5], [3 8], [5 12]};
  trial = @(modes) run_model (mechanism_kind (), fine, build_mechanism (fine, mechanism_rungs (same (fine, modes), [])));
endfunction

function scene = same (scene, modes)
  for k = 1:numel (scene.bodies)
    scene.bodies(k).model.modes = modes;
  endfor
endfunction

function [trial, sizes, scene] = curved_trials (scene)
  scene = check_scene (scene);
  fine = setfield (scene, "solver", "tolerance", scene.solver.tolerance/50);
  sizes = {[0 0], [1 2], [2 3], [3 5], [5 8], [8 12], [12 18], [18 27]};
  trial = @(modes) trial_run (fine, setfield (rung_of_scene (setfield (scene, "model", "modes", modes)), ...
                                              "stiffening", "none"));
endfunction

%!test # more modes, a smaller error
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   scene = setfield (setfield (double_pendulum (), "duration", 0.05), "solver", "tolerance", 1e-3);
%!   evalc ("table = convergence_ladder (scene, folder);");
%!   assert (issorted (fliplr ([table.error_m])));
%!   evalc ("table = convergence_ladder (setfield (arc_pendulum (), \"duration\", 0.1), folder);");
%!   assert (table(end).error_m < table(2).error_m);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
