## -*- texinfo -*-
## @deftypefn {} {} run_pairs (@var{kinds}, @var{seed})
## All pairs of fields and their values, for the @var{kinds} "rod", "mechanism" and "surface" (default: all): prints
## which values do not go together and why, `not ok' where that is no reason of mechanics, and closes each kind with
## its counts.
## @end deftypefn

function run_pairs (kinds = {"rod", "mechanism", "surface"}, seed = 1)
  rand ("twister", seed);
  for kind = kinds
    [base, choices] = feval ([kind{1} "_choices"]);
    start = tic ();
    counts = all_pairs (kind{1}, base, choices);
    printf ("%s: %d scenes in %.0f s: of %d pairs %d ran, %d were refused; %d faults\n", kind{1}, counts.scenes, ...
            toc (start), counts.pairs, counts.ran, counts.refused, counts.faults);
  endfor
endfunction

%!error <nothing_choices> run_pairs ({"nothing"})
