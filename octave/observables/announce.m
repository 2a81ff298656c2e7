## -*- texinfo -*-
## @deftypefn {} {} announce (@var{choice})
## Say which rungs of the ladder were tried for the model (see @code{choose_model}), what each cost, and which was
## taken.
## @end deftypefn

function announce (choice)
  for tried = choice.tried(:).'
    say ("  %-62s %8.2g m %6.2f s %7d calls%s", tried.name, tried.error_m, tried.seconds, tried.calls, ...
         repmat (" <-", 1, isequal (tried.rung, choice.trial.rung)));
  endfor
endfunction

%!test
%! rung = struct ("bending", 1);
%! tried = struct ("rung", rung, "name", "1 bending mode", "error_m", 1e-5, "seconds", 0.5, "calls", 70);
%! text = evalc ("announce (struct ('tried', tried, 'trial', struct ('rung', rung)))");
%! assert (! isempty (regexp (text, "1 bending mode .*1e-05 m   0.50 s      70 calls <-")));
