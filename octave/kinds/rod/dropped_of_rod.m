## -*- texinfo -*-
## @deftypefn {} {@var{dropped} =} dropped_of_rod (@var{scene}, @var{run}, @var{reference})
## What all models of a straight rod drop in the motion of a @var{run}, beside a richer @var{reference}: see
## @code{dropped_error}.
##
## A rod that rings along its length rings its bending by what is dropped: by modes that are as slow, chosen or
## not.  They are those of the @var{reference}.
## @end deftypefn

function dropped = dropped_of_rod (scene, run, reference)
  run = with_slow_modes (scene, run, reference.model);
  dropped = dropped_error (scene, run.model, run.history);
endfunction

function run = with_slow_modes (scene, run, richer)
  rung = run.model.rung;
  if (! (strcmp (rung.axial, "dynamic") && strcmp (richer.rung.axial, "dynamic")))
    return;
  endif
  omega = sqrt (diag (richer.arrays.stiffness_matrix)./diag (richer.arrays.mass_matrix));
  along = columns (richer.basis) - richer.rung.bending;
  rung.bending = sum (omega(along+1:end) < 1.5*min (omega(1:along)));
  if (rung.bending > run.model.rung.bending)
    trial = try_rung (ladder_of (rod_kind (), scene), rung);
    if (isempty (trial.error))
      run = trial;
    endif
  endif
endfunction

%!test # slow enough to ring with the stretching: four modes beside three
%! scene = check_scene (random_loaded_scene (6));
%! rung = @(n) struct ("sines", [], "bending", n, "longitudinal", 2, "axial", "dynamic", "stiffening", "foreshortening");
%! [run, richer] = deal (trial_run (scene, rung (3)), trial_run (scene, rung (6)));
%! assert (dropped_error (scene, run.model, run.history).metres < 1e-6);
%! assert (dropped_of_rod (scene, run, richer).metres, 6.0e-6, 0.1e-6);  # of 30 + 30 modes
