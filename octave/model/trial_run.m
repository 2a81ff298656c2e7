## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} trial_run (@var{scene}, @var{rung})
## Try a @var{rung} of the ladder on a checked scene: a struct of the rung, its model, the centreline at the frame
## times (x, y: 21 stations by frames, m), calls of the rate and seconds.  An integration that fails leaves error, its
## message, and NaN for the centreline.
## @end deftypefn

function trial = trial_run (scene, rung)
  start = tic ();
  trial = struct ("rung", rung, "model", build_model (scene, rung), "error", "", "history", []);
  times = frame_times (scene);
  stations = linspace (0, scene.rod.length, 21);
  try
    system = rod_system (scene, trial.model);
    [states, count] = integrate (system, times, struct ("name", "auto", "tolerance", scene.solver.tolerance/5));
    trial.history = measure (system, trial.model, times, states);
    watch_balance (trial.history, system, count);
    [trial.x, trial.y] = centreline (trial.model, stations, trial.history, 1);
    trial.count = count;
    trial.calls = count.calls;
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    trial.error = strtrim (err.message);
    [trial.x, trial.y] = deal (NaN (21, numel (times)));
    trial.count = struct ("method", "auto", "seconds", NaN, "calls", 0);
    trial.calls = 0;
  end_try_catch
  trial.seconds = toc (start);
endfunction

%!test # the rigid rod
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = trial_run (check_scene (setfield (paper (), "solver", "tolerance", 1e-6)), rigid);
%! assert (size (trial.x), [21 91]);
%! assert (hypot (trial.x(end,:), trial.y(end,:)), ones (1, 91), 1e-12);
