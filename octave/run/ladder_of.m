## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} ladder_of (@var{kind}, @var{scene}, @var{left}, @var{solver})
## The ladder of models of a checked scene of a @var{kind} (see @code{kind_of}), as @code{choose} takes it: its trials
## are runs by the ladder's solver, or by a sharper @var{solver}.  One that takes more than a third of the seconds that
## @var{left} () says is given up, and so is one whose rods reach a slope of 1.5 (see @code{refuse_steep}).
## @end deftypefn

function ladder = ladder_of (kind, scene, left = @() Inf, solver = [])
  ladder = kind.ladder (scene);
  ladder.drift = @phase_drift;
  if (! isempty (solver))
    ladder.solver = solver;
    ladder.drift = @(trial) 0;
  endif
  in_time = @() setfield (setfield (ladder.solver, "steepest", 1.5), "seconds", left ()/3);
  ladder.trial = @(rung, like) run_model (kind, scene, kind.build (scene, rung), in_time (), like);
  tighter = @(trial) kind.tighter (ladder.solver, max (energy_error (trial.history)));
  ladder.sharper = @(trial) ladder_of (kind, scene, left, tighter (trial));
  ladder.dropped = @(trial) dropped_metres (kind.dropped (scene, trial, trial));
endfunction

function metres = dropped_metres (dropped)
  metres = 0;
  if (! isempty (dropped))
    metres = dropped.metres;
  endif
endfunction

%!test # the rigid rod
%! scene = check_scene (setfield (paper (), "solver", "tolerance", 1e-6));
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = try_rung (ladder_of (rod_kind (), scene), rigid);
%! assert (hypot (trial.x(end,:), trial.y(end,:)), ones (1, 91), 1e-12);
%! assert (trial.rung, rigid); assert (trial.error, "");
%!error <given up after> ladder_of (rod_kind (), check_scene (paper ()), @() 1e-3).trial (rung_of_scene (
%!   setfield (check_scene (paper ()), "model", "modes", [7 7])), [])
