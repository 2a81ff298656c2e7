## -*- texinfo -*-
## @deftypefn {} {@var{faults} =} run_pairs (@var{kinds}, @var{seed})
## All pairs of fields and their values, for the @var{kinds} "rod", "mechanism" and "surface" (default: all): prints
## which values do not go together and why, `not ok' where that is no reason of mechanics, and closes each kind with
## its counts.  @var{faults} is the number of sets of values that end in an error of Octave's own, or in something
## wrong.
## @end deftypefn

function faults = run_pairs (kinds = {"rod", "mechanism", "surface"}, seed = 1)
  rand ("twister", seed);
  faults = 0;
  for kind = kinds
    [base, choices] = feval ([kind{1} "_choices"]);
    start = tic ();
    counts = all_pairs (kind{1}, base, choices);
    faults += counts.faults;
    printf ("%s: %d scenes in %.0f s: of %d pairs %d ran, %d were refused; %d faults\n", kind{1}, counts.scenes, ...
            toc (start), counts.pairs, counts.ran, counts.refused, counts.faults);
  endfor
endfunction

%!error <nothing_choices> run_pairs ({"nothing"})
