## -*- texinfo -*-
## @deftypefn {} {@var{run} =} balanced_run (@var{kind}, @var{scene}, @var{model}, @var{choice}, @var{left})
## The run (see @code{kind_of}) of a checked scene by its solver.  A model that was chosen has a trial run (see
## @code{choose}), which is taken for the solver "auto", and for that by which it is where it keeps its energy balance.
## "auto" is asked for less, or for another method (tighter of a kind), six times at most, until the balance is within
## 1e-7 of what changes (see @code{energy_error}), or until a second and later attempt does not help: what no point
## follows, the work and what dissipates, may be off by more than the points, and implicit methods damp what their
## steps pass over, small as its way may be.  An attempt that takes more than half of the seconds @var{left} () ends
## that, and the run before it is taken.
## @end deftypefn

function run = balanced_run (kind, scene, model, choice, left = @() Inf)
  solver = setfield (scene.solver, "seconds", left ()/2);
  if (isempty (choice.trial))
    run = run_model (kind, scene, model, solver);
  elseif (serves (choice.trial, solver.name))
    run = choice.trial;
  else
    solver.tolerance /= 4;  # the model has most of it
    run = run_model (kind, scene, model, solver, choice.trial);
  endif
  last = Inf;
  off = max (energy_error (run.history));
  attempts = 0;
  while (strcmp (scene.solver.name, "auto") && off > 1e-7 && (off <= last/2 || attempts < 2) && attempts < 6)
    solver = setfield (kind.tighter (solver, off), "seconds", left ()/2);
    before = run.count;
    try
      run = run_model (kind, scene, model, solver, run);
    catch err
      rethrow_others (err, "toolchain:integration:time");
      break;
    end_try_catch
    run.count.seconds += before.seconds;
    run.count.calls += before.calls;
    last = off;
    off = max (energy_error (run.history));
    attempts++;
  endwhile
endfunction

function yes = serves (trial, name)
  yes = strcmp (name, "auto") || (strcmp (name, trial.count.method) && max (energy_error (trial.history)) <= 1e-7);
endfunction

%!test # the balance is kept to 1e-7, whatever the tolerance
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), ...
%!                                "solver", struct ("name", "auto", "tolerance", 1e-3)));
%! [model, choice] = chosen_model (rod_kind (), scene);
%! assert (energy_error (balanced_run (rod_kind (), scene, model, choice).history) <= 1e-7);
%!test # where no time is left, what is there is taken
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), "solver", "tolerance", 1e-3));
%! model = build_model (scene, rung_of_scene (scene));
%! trial = run_model (rod_kind (), scene, model);
%! trial.history.balance(end) += range (trial.history.U);
%! run = balanced_run (rod_kind (), scene, model, struct ("trial", trial), @() 1e-6);
%! assert (run.history.balance, trial.history.balance); assert (any (energy_error (run.history) > 1e-7));
%!test # and so are the moment's work, whose power follows modes that no step resolves, and what dissipates
%! for scene = {setfield(paper (), "solver", "tolerance", 6e-6), setfield(damped (), "solver", "tolerance", 6e-6)}
%!   scene = check_scene (setfield (scene{1}, "model", "modes", [0 6]));
%!   [model, choice] = chosen_model (rod_kind (), scene);
%!   run = balanced_run (rod_kind (), scene, model, choice);
%!   assert (energy_error (run.history) <= 1e-7);
%!   assert (run.count.calls < 4e5);
%! endfor
%!test # 230 J that turn hide no error of what vibrates, and longitudinal modes that follow keep the balance, too
%! scene = check_scene (setfield (setfield (fast_spin (), "gravity", 0), "solver", "tolerance", 1e-4));
%! rung = struct ("sines", [], "bending", 3, "longitudinal", 0, "axial", "quasistatic", "stiffening", "foreshortening");
%! history = balanced_run (rod_kind (), scene, build_model (scene, rung), struct ("trial", [])).history;
%! off = max (abs (history.balance - history.balance(1)));
%! assert (max (history.T) > 200 && range (history.U) < 0.03);
%! assert (off <= 1e-7*range (history.U)*1.5);
%!test
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 0]), "solver", "tolerance", 1e-4));
%! [model, choice] = chosen_model (rod_kind (), scene);
%! run = balanced_run (rod_kind (), scene, model, choice);
%! assert (numel (run.history.t), 91);
%!error <lsode_bdf stopped at t = .* s of 1.8 s: the energy balance is off by .*; try a smaller tolerance or step, fewer modes>
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), ...
%!                                "solver", struct ("name", "lsode_bdf", "tolerance", 1)));
%! [model, choice] = chosen_model (rod_kind (), scene);
%! balanced_run (rod_kind (), scene, model, choice);
%!test # a rod that rings: damped by less than its tolerance, but not out of its balance
%! scene = setfield (chain (1), "duration", 0.5);
%! scene.bodies{1}.rod = struct ("length", 1, "EA", 1e6, "EI", 20, "rhoA", 1);
%! scene.bodies{1}.model.modes = [0 2];
%! scene.bodies{1}.initial.V2 = [0 1e-3];
%! scene.solver.tolerance = 1e-3;
%! scene = check_mechanism (scene);
%! [model, choice] = chosen_model (mechanism_kind (), scene);
%! assert (max (energy_error (run_model (mechanism_kind (), scene, model).history)) > 1e-6);
%! run = balanced_run (mechanism_kind (), scene, model, choice);
%! assert (energy_error (run.history) <= 1e-7);
%! first = run_model (mechanism_kind (), scene, model);
%! last = run_model (mechanism_kind (), scene, model, setfield (scene.solver, "tolerance", 1e-6), first);
%! assert (run.count.calls > first.count.calls + last.count.calls/2);  # of all attempts
%!test # a model is chosen by `auto', and then run by the scene's solver, once
%! scene = setfield (chain (1), "duration", 0.02);
%! scene.bodies{1}.model.modes = "auto";
%! scene.solver = struct ("name", "variational", "step", 1e-3, "tolerance", 1e-3);
%! scene = check_mechanism (scene);
%! [model, choice] = chosen_model (mechanism_kind (), scene);
%! run = balanced_run (mechanism_kind (), scene, model, choice);
%! assert (run.count.method, "variational"); assert (choice.trial.count.method, "radau");
%! assert (run.solver.tolerance, 1e-3/4, 1e-12);  # a quarter of what is asked is left to it
%! scene.solver.name = "auto";
%! run = balanced_run (mechanism_kind (), scene, model, choice);
%! assert (run.history, choice.trial.history); assert (run.count, choice.trial.count);
%!test # a trial on a surface asks less of the balance than a run
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.04));
%! [model, choice] = chosen_model (surface_kind (), scene);
%! assert (energy_error (balanced_run (surface_kind (), scene, model, choice).history) <= 1e-7);
