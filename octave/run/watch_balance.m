## -*- texinfo -*-
## @deftypefn {} {} watch_balance (@var{history}, @var{system}, @var{count})
## Stop where a run's energy balance left its bound, a twentieth of what changes (see @code{energy_error}), or its
## states are no numbers: an integration can be wrong without an error of its own.  @var{count} comes from
## @code{integrate}; a rod that stays within its tolerance of where it began (@var{count}.still) has no balance to
## lose.
## @end deftypefn

function watch_balance (history, system, count)
  off = energy_error (history);
  first = find (! (off <= 0.05), 1);
  if (! isempty (first) && ! count.still)
    what = sprintf ("the energy balance is off by %.2g of what changes, more than 0.05", off(first));
    stop_integration (count.method, system, history.t(first), history.t(end)/count.steps, what, ...
                      "a smaller tolerance or step");
  endif
endfunction

%!function history = of_balance (balance)
%!  history = struct ("t", 1:3, "T", [1 2 1], "U", [0 0 0], "Z", [0 0 0], "W", [0 0 0], "D", [0 0 0], ...
%!                    "balance", balance, "energy_floor", 0);
%!endfunction
%!error <rk4 stopped at t = 2 s of 3 s: .* balance is off by 1 of what changes, more than 0.05: a step of>
%! count = struct ("method", "rk4", "steps", 100, "still", false);
%! watch_balance (of_balance ([1 2 5]), struct ("stiffness", 1, "mass", 1, "duration", 3), count);
%!error <the energy balance is off by NaN>
%! count = struct ("method", "rk4", "steps", 100, "still", false);
%! watch_balance (of_balance ([1 NaN 5]), struct ("stiffness", 1, "mass", 1, "duration", 3), count);
%!test # noise of a rod at rest
%! watch_balance (of_balance ([1 2 5]), struct (), struct ("method", "rk4", "steps", 100, "still", true));
