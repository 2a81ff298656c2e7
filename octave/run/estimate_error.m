## -*- texinfo -*-
## @deftypefn {} {@var{estimate} =} estimate_error (@var{kind}, @var{scene}, @var{run}, @var{reference})
## The estimated error of the @var{run} of a chosen model (see @code{kind_of}) against the rod, of which the
## @var{reference} is a richer model's run (see @code{choose}): a struct of
##
## @table @code
## @item metres
## the largest distance of the points from those of the richer model, moved by what the whole family of models drops
## @item of_choice
## the same without what is dropped
## @item rod
## the richer model's run with its points so moved, as near to the rod as is known
## @item dropped
## the largest distance by which that moves them (empty where it is not known)
## @item seconds
## what it took
## @end table
## @end deftypefn

function estimate = estimate_error (kind, scene, run, reference)
  start = tic ();
  estimate.metres = estimate.of_choice = distance (run, reference);
  estimate.dropped = [];
  estimate.rod = reference;
  dropped = kind.dropped (scene, run, reference);
  if (! isempty (dropped))
    estimate.rod.x += dropped.x;
    estimate.rod.y += dropped.y;
    estimate.metres = distance (run, estimate.rod) + dropped.bound;
    estimate.dropped = dropped.metres;
  endif
  estimate.seconds = toc (start);
endfunction

%!test # a rod that does not bend drops nothing
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "solver", "tolerance", 1e-3));
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = trial_run (scene, rigid);
%! reference = setfield (setfield (trial, "x", trial.x + 3e-6), "y", trial.y - 4e-6);
%! estimate = estimate_error (rod_kind (), scene, trial, reference);
%! assert ([estimate.metres, estimate.of_choice, estimate.dropped], [5e-6 5e-6 0], 1e-12);
%!test # the richer model's points are moved by what is dropped, whose own error is added
%! place = @(x, y) struct ("x", x, "y", y);
%! kind.dropped = @(scene, run, reference) struct ("x", 1e-6, "y", 8e-6, "bound", 1e-7, "metres", 9e-6);
%! estimate = estimate_error (kind, struct (), place (0, 0), place (4e-6, 4e-6));
%! assert ([estimate.rod.x, estimate.rod.y], [5e-6 12e-6], 1e-15);
%! assert ([estimate.metres, estimate.of_choice, estimate.dropped], [13.1e-6, sqrt(32)*1e-6, 9e-6], 1e-12);
%!test # Kane's spin-up at 1e-4 m: the exact rod is 3.2e-3 m away (two codes), and it is said
%! evalc ("summary = driver ('spin_up', 'tolerance', 1e-4, 'exact', false, 'output', '').summary;");
%! assert (summary.estimated_error_m, 3.2e-3, 0.3e-3);
%! assert (summary.dropped_m, 3.2e-3, 0.3e-3);
%! said = regexp (summary.warnings, "is 0.0033 m, the tolerance 0.0001 m: 0.0033 m of it is what all these models drop");
%! assert (sum (cellfun (@numel, said)), 1);
%!test # a spin-up by a torque: the exact rod on the plane (9 + 9 polynomials) is 8.75e-5 m from the model of 13 modes
%! scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.001), "gravity", 0, "duration", 0.8);
%! scene.moment = @(t) 0.8*sin (pi*t/1.5).^2;
%! scene.model.energy = "uniaxial";
%! scene.solver.tolerance = 2e-5;
%! evalc ("summary = driver (scene, 'exact', false, 'output', '').summary;");
%! assert (summary.estimated_error_m, 8.75e-5, 0.3*8.75e-5);
%! assert (! isempty (strfind (summary.warnings{1}, "EXACT=yes, or the option \"exact\"")));
%!test # a force along a rod in a hub lets it ring near its fourth frequency, which the three modes chosen do not have
%! evalc ("summary = driver (random_loaded_scene (6), 'exact', false, 'output', '').summary;");
%! assert (summary.dropped_m, 6.0e-6, 0.1e-6);  # of 30 + 30 modes
%! assert (summary.estimated_error_m > 1.5*summary.tolerance_m);
