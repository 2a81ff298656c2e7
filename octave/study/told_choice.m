## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} told_choice (@var{ladder}, @var{tolerance})
## The choice of a rung (see @code{choose}) for a study: its warnings are printed.  It is an error that none could be
## run in the study's time.
## @end deftypefn

function choice = told_choice (ladder, tolerance)
  try
    choice = choose (ladder, tolerance);
  catch err
    if (strcmp (err.identifier, "toolchain:integration:time"))
      scene_error (["no model of the ladder could be run in a third of the seconds that were left, the last was %s:" ...
                    " take more, BUDGET=300 say, or a tolerance above %.2g m"], strtrim (err.message), tolerance);
    endif
    rethrow (err);
  end_try_catch
  cellfun (@(text) say ("warning: %s", text), choice.warnings);
endfunction

%!test # without time a trial is given up, and what is left says so
%! scene = check_scene (setfield (paper (), "solver", "tolerance", 1e-9));
%! fail ("told_choice (ladder_of (rod_kind (), scene, @() 1e-3), 1e-9)", ...
%!       "no model of the ladder could be run in a third of the seconds that were left, .*: take more, BUDGET=300 say,");
%! scene = check_scene (setfield (swing (), "duration", 0.1));
%! said = evalc ("choice = told_choice (ladder_of (rod_kind (), scene), 1e-3);");
%! assert (said, ""); assert (choice.error_m <= 1e-3);
