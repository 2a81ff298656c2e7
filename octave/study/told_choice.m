## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} told_choice (@var{ladder}, @var{tolerance})
## The choice of a rung (see @code{choose}) for a study: its warnings are printed.
## @end deftypefn

function choice = told_choice (ladder, tolerance)
  choice = choose (ladder, tolerance);
  cellfun (@(text) say ("warning: %s", text), choice.warnings);
endfunction

%!test # without time a trial is given up, and what is left says so
%! scene = check_scene (setfield (paper (), "solver", "tolerance", 1e-9));
%! fail ("told_choice (ladder_of (rod_kind (), scene, @() 1e-3), 1e-9)", "given up after");
%! scene = check_scene (setfield (swing (), "duration", 0.1));
%! said = evalc ("choice = told_choice (ladder_of (rod_kind (), scene), 1e-3);");
%! assert (said, ""); assert (choice.error_m <= 1e-3);
