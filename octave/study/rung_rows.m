## -*- texinfo -*-
## @deftypefn {} {@var{table} =} rung_rows (@var{kind}, @var{scene}, @var{ladder}, @var{choice}, @var{reference}, @
##   @var{seconds})
## Rows (see @code{rung_row}) of the rungs around the one that a @var{choice} took from the @var{ladder} of a checked
## scene of a @var{kind} (see @code{kind_of}), with their distances from the run @var{reference}: the chosen one, its
## reference, and, in the ladder's order, what else the @var{seconds} allow.  What the choice has run is not run again.
## @end deftypefn

function table = rung_rows (kind, scene, ladder, choice, reference, seconds)
  table = struct ([]);
  clock = tic ();
  known = {choice.trial, choice.reference};
  left_out = 0;
  for rung = kind.rungs (scene, choice.rung, choice.reference.rung)
    left = seconds - toc (clock);
    is_known = any (cellfun (@(trial) isequal (trial.rung, rung{1}), known));
    ladder.trial = ladder_of (kind, scene, @() 3*left).trial;
    if (is_known || left > 0)
      trial = run_once (ladder, rung{1}, known);
    endif
    if (! is_known && (left <= 0 || strcmp (trial.identifier, "toolchain:integration:time")))
      left_out++;
    else
      table = [table, rung_row(ladder, rung{1}, trial.count, distance (trial, reference), choice.rung)];
    endif
  endfor
  if (left_out > 0)
    say ("  %d more rungs of the ladder would have taken longer than the %.0f s that were left for them", ...
         left_out, seconds);
  endif
endfunction

%!test # the chosen rung and its reference have the trials of the choice
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "stiffening", "none"));
%! ladder = ladder_of (rod_kind (), scene);
%! choice = choose (ladder, scene.solver.tolerance);
%! evalc ("table = rung_rows (rod_kind (), scene, ladder, choice, choice.reference, 60);");
%! assert (table([table.chosen]).seconds, choice.trial.count.seconds);
%! assert (table([table.chosen]).error_m, choice.error_m);
%! said = evalc ("few = rung_rows (rod_kind (), scene, ladder, choice, choice.reference, 0);");
%! assert ({few.model}, {table([1 end]).model});  # no time for what has not been run
%! assert (regexp (said, '(\d+) more rungs', "tokens"), {{num2str(numel (table) - 2)}});
