## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} error_warning (@var{tolerance}, @var{estimate}, @var{instead})
## A cellstr: empty, or a warning that the estimated error (see @code{estimate_error}) is beyond the @var{tolerance}
## (m), with what the models drop, where that is the cause, and what to take @var{instead} (a text).
## @end deftypefn

function warnings = error_warning (tolerance, estimate, instead)
  warnings = {};
  if (estimate.metres <= tolerance)
    return;
  endif
  remedy = "take a smaller tolerance or another solver";
  if (estimate.dropped > tolerance)
    remedy = sprintf ("%.2g m of it is what all these models drop against the geometrically exact rod: %s", ...
                      estimate.dropped, instead);
  elseif (estimate.of_choice <= tolerance)
    remedy = sprintf (["%.2g m of it may be what all these models drop against the geometrically exact rod:" ...
                       " take half the tolerance, or %s"], estimate.dropped, instead);
  endif
  warnings = {sprintf("the estimated error is %.2g m, the tolerance %.2g m: %s", estimate.metres, tolerance, remedy)};
endfunction

%!function text = said (scene, metres, of_choice, dropped)
%!  estimate = struct ("metres", metres, "of_choice", of_choice, "dropped", dropped);
%!  text = [error_warning(1e-4, estimate, rod_kind ().instead (check_scene (scene))){:}];
%!endfunction
%!assert (isempty (said (slender (), 9e-5, 9e-5, 0)))
%!assert (regexp (said (slender (), 2e-4, 2e-4, 0), "error is 0.0002 m, the tolerance 0.0001 m: take a smaller"), 15)
%!assert (regexp (said (slender (), 2e-4, 2e-4, []), "error is 0.0002 m, the tolerance 0.0001 m: take a smaller"), 15)
%!test
%! text = said (slender (), 3e-3, 4e-5, 3.2e-3);
%! assert (! isempty (regexp (text, "0.0032 m of it is what all .* drop .*: EXACT=yes")), text);
%! text = said (setfield (slender (), "initial", "from", "equilibrium"), 3e-3, 4e-5, 3.2e-3);
%! assert (! isempty (regexp (text, "0.0032 m of it is what all these models drop .* rods welded together")), text);
