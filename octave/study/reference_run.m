## -*- texinfo -*-
## @deftypefn {} {@var{run} =} reference_run (@var{kind}, @var{scene}, @var{model}, @var{seconds})
## What the integrations of a @var{model} of a checked scene of a @var{kind} are measured against: a run by the method
## of kind.reference (see @code{kind_of}) at tolerances that fall from 1e-4 m by hundreds to the one that stands there,
## as far as so many @var{seconds} allow.
##
## @var{run} has the points x, y (and z) at the @var{times} of the frames and some before the fourth, so that what is
## slow can be compared early; the method's @var{name}, the @var{tolerance} (m) and @var{off} (m), what the tolerance
## before differs from it by.
## @end deftypefn

function run = reference_run (kind, scene, model, seconds)
  frames = frame_times (scene);
  early = frames(end)*2.^(-(20:-1:0)/2);
  times = union (frames, early(early < frames(min (5, end))));
  system = started_system (kind, scene, model);
  [name, finest] = kind.reference{:};
  run = [];
  solver = setfield (scene.solver, "name", name);
  clock = tic ();
  tolerances = 10.^(-4:-2:-16);
  for tolerance = [tolerances(tolerances > 1.01*finest), finest]
    solver.tolerance = tolerance;
    start = tic ();
    [states, count] = integrate (system, times, solver);
    before = run;
    run = kind.observe (scene, model, system, times, states);
    run.times = times;
    run.name = name;
    run.tolerance = tolerance;
    run.off = NaN;
    if (tolerance < 1e-4)
      run.off = distance (run, before);
    endif
    if (tolerance < 1e-4 && toc (clock) + 3*toc (start) > seconds)
      break;
    endif
  endfor
endfunction

%!test # a rigid pendulum: within its tolerance of finer steps; no time takes the second
%! scene = check_scene (setfield (setfield (swing (), "model", "modes", [0 0]), "duration", 0.5));
%! model = build_model (scene, rung_of_scene (scene));
%! run = reference_run (rod_kind (), scene, model, 60);
%! assert (run.tolerance, 1e-10); assert (run.off <= 1e-8);
%! assert (ismember (frame_times (scene), run.times)); assert (run.times(2) < 1e-3);
%! assert (columns (run.x), numel (run.times));
%! first = reference_run (rod_kind (), scene, model, 0);
%! assert (first.tolerance, 1e-6); assert (first.off <= 1e-4); assert (distance (first, run) <= 1e-6);
