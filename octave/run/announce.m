## -*- texinfo -*-
## @deftypefn {} {} announce (@var{choice})
## Say which rungs of the ladder were tried for the model (see @code{choose}), what each is off by and cost, and which
## was taken, but for a useless one.
## @end deftypefn

function announce (choice)
  for tried = choice.tried(:).'
    taken = "";
    if (isequal (tried.rung, choice.rung) && ! choice.useless)
      taken = " <-";
    endif
    if (isempty (tried.message))
      say ("  %-62s %8.2g m %6.2f s %7d calls%s", tried.name, tried.error_m, tried.seconds, tried.calls, taken);
    else
      say ("  %-62s could not be run", tried.name);
    endif
  endfor
endfunction

%!test
%! tried = struct ("rung", {1, 0}, "name", {"1 bending mode", "rigid"}, "error_m", {1e-5, Inf}, "seconds", 0.5, ...
%!                 "calls", {70, 0}, "message", {"", "its constraints depend on each other"});
%! text = evalc ("announce (struct ('tried', tried, 'rung', 1, 'useless', false))");
%! assert (! isempty (regexp (text, "1 bending mode .*1e-05 m   0.50 s      70 calls <-")));
%! assert (! isempty (regexp (text, "rigid +could not be run\n")));
%! text = evalc ("announce (struct ('tried', tried, 'rung', 1, 'useless', true))");
%! assert (isempty (strfind (text, "<-")));
%!test # nothing was chosen
%! assert (evalc ("announce (struct ('tried', [], 'rung', 1, 'useless', false))"), "");
