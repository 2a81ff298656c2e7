## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} choose_curved (@var{scene})
## The fewest base functions of a curved rod whose centreline is within the scene's tolerance in every frame, for
## model.modes = "auto": [N1 N2] grows by half until twice as many move no point by more than 95 % of it.  @var{choice}
## is like that of @code{choose_model}.
## @end deftypefn

function choice = choose_curved (scene)
  sizes = {[0 0], [1 2], [2 3], [3 5], [5 8], [8 12], [12 18], [18 27], [27 40]};
  limit = 0.95*scene.solver.tolerance;
  trials = {};
  do
    trials{end+1} = trial_run (scene, curved_rung (sizes{numel (trials) + 1}));
    off = Inf;
    if (numel (trials) > 2)
      off = distance (trials{end-2}, trials{end});
    endif
  until (off <= limit || numel (trials) == numel (sizes))
  reference = trials{end};
  trial = trials{max (numel (trials) - 2, 1)};
  warnings = {};
  if (! (off <= limit))
    warnings = {sprintf("%d + %d base functions move points by %.2g m more, the tolerance is %.2g m", ...
                        reference.rung.sines, off, scene.solver.tolerance)};
  endif
  tried = cellfun (@(t) struct ("rung", t.rung, "name", rung_name (t.rung), "error_m", distance (t, reference), ...
                                "seconds", t.seconds, "calls", t.calls), trials);
  choice = struct ("trial", trial, "reference", reference, "error", distance (trial, reference), "tried", tried, ...
                   "reason", "more base functions, twice as many, move no point by more than the tolerance");
  choice.warnings = warnings;
endfunction

function rung = curved_rung (sines)
  rung = struct ("sines", sines, "bending", sines(2), "longitudinal", sines(1), ...
                 "axial", {{"none", "dynamic"}{1 + (sines(1) > 0)}}, "stiffening", "none");
endfunction

%!test
%! scene = check_scene (setfield (arc_pendulum (), "duration", 0.2));
%! scene.solver.tolerance = 1e-3;
%! choice = choose_curved (scene);
%! assert (choice.error <= 1e-3); assert (isempty (choice.warnings));
