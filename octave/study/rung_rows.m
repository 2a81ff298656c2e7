## -*- texinfo -*-
## @deftypefn {} {@var{table} =} rung_rows (@var{kind}, @var{scene}, @var{ladder}, @var{choice}, @var{reference})
## Rows (see @code{rung_row}) of the rungs around the one that a @var{choice} took from the @var{ladder} of a checked
## scene of a @var{kind} (see @code{kind_of}), with their distances from the run @var{reference}.  What the choice has run
## is not run again.
## @end deftypefn

function table = rung_rows (kind, scene, ladder, choice, reference)
  table = struct ([]);
  for rung = kind.rungs (scene, choice.rung, choice.reference.rung)
    trial = run_once (ladder, rung{1}, {choice.trial, choice.reference});
    table = [table, rung_row(ladder, rung{1}, trial.count, distance (trial, reference), choice.rung)];
  endfor
endfunction

%!test # the chosen rung and its reference have the trials of the choice
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "stiffening", "none"));
%! ladder = ladder_of (rod_kind (), scene);
%! choice = choose (ladder, scene.solver.tolerance);
%! evalc ("table = rung_rows (rod_kind (), scene, ladder, choice, choice.reference);");
%! assert (table([table.chosen]).seconds, choice.trial.count.seconds);
%! assert (table([table.chosen]).error_m, choice.error_m);
