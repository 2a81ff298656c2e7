## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{choice}] =} choose_surface (@var{scene})
## The motion of the rod of a checked scene on its surface, with the scene's modes or with the fewest polynomials that
## keep every point of the centreline within the scene's tolerance of a run with more.
##
## @var{run} is a struct of rung (the modes), scene (with these), system, history and count.  @var{choice}: reason (a
## sentence), tried (a struct array of rung, name, error_m, seconds, calls; see @code{announce}), trial, error_m (of
## @var{run}, m, or empty) and warnings (cellstr).  What fails with two numbers of polynomials, one after the other, is
## an error.
## @end deftypefn

function [run, choice] = choose_surface (scene)
  choice = struct ("reason", "as the scene states it", "tried", [], "trial", [], "error_m", [], "warnings", {{}});
  if (isnumeric (scene.model.modes))
    run = surface_run (scene, scene.model.modes, 3e-9);
    return;
  endif
  trials = try_numbers (scene, [4 6 8 10 13 16 20 25 32]);
  off = cellfun (@(trial) apart (trial, trials{end}), trials);
  found = find (off <= scene.solver.tolerance, 1);
  if (numel (trials) > 1 && apart (trials{end-1}, trials{end}) > scene.solver.tolerance)
    choice.warnings = {sprintf(["%d + %d polynomials are within %.2g m of %d + %d only, the tolerance is %.2g m: " ...
                                "take a larger one, or give model.modes"], trials{end-1}.rung, off(end-1), ...
                               trials{end}.rung, scene.solver.tolerance)};
  endif
  run = surface_run (scene, trials{found}.rung, 3e-9);
  choice.trial = trials{found};
  choice.error_m = off(found);
  choice.reason = sprintf ("the fewest within %.2g m of %d + %d", scene.solver.tolerance, trials{end}.rung);
  choice.tried = cellfun (@(trial, off) struct ("rung", trial.rung, "name", polynomials (trial.rung), ...
                                                "error_m", off, "seconds", trial.count.seconds, ...
                                                "calls", trial.count.calls), ...
                          trials, num2cell (off));
endfunction

## runs with so many polynomials, until two that follow each other are within the tolerance of each other
function trials = try_numbers (scene, numbers)
  trials = {};
  failed = 0;
  for n = numbers
    show_progress (["trying " polynomials([n n])]);
    try
      trials{end+1} = surface_run (scene, [n n], Inf);
      failed = 0;
    catch err
      failed += 1;
      if (failed == 2 || ! strcmp (err.identifier, "toolchain:integration"))
        rethrow (err);
      endif
    end_try_catch
    if (failed == 0 && numel (trials) > 1 && apart (trials{end-1}, trials{end}) <= scene.solver.tolerance)
      break;
    endif
  endfor
endfunction

function text = polynomials (rung)
  text = sprintf ("%d + %d polynomials", rung);
endfunction

function run = surface_run (scene, modes, balance)
  scene.model.modes = modes;
  system = surface_rod (scene);
  [history, count] = run_surface (system, scene, balance);
  run = struct ("rung", modes, "scene", scene, "system", system, "history", history, "count", count);
endfunction

function metres = apart (a, b)
  [a, b] = deal (a.history, b.history);
  metres = max (sqrt ((a.x - b.x).^2 + (a.y - b.y).^2 + (a.z - b.z).^2)(:));
endfunction

%!test # the fewest: with fewer the centreline is off by more than the tolerance
%! scene = setfield (setfield (large_swing (), "duration", 0.2), "solver", "tolerance", 1e-4);
%! [run, choice] = choose_surface (check_surface_scene (scene));
%! assert (choice.error_m <= 1e-4);
%! k = find (cellfun (@(rung) isequal (rung, run.rung), {choice.tried.rung}));
%! assert (k > 1);
%! assert ([choice.tried(1:k-1).error_m] > 1e-4);
%! rich = driver (scene, "output", "", "modes", [20 20]).history;
%! assert (hypot (rich.x - run.history.x, rich.z - run.history.z) < 1.2e-4);
