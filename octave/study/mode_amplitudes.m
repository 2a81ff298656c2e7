## -*- texinfo -*-
## @deftypefn {} {@var{found} =} mode_amplitudes (@var{system}, @var{mode}, @var{name}, @var{h}, @var{times})
## How much of the @var{mode} (see @code{highest_mode}) is in the difference of two motions of the @var{system}, of
## which one begins at its initial state, the other beside it by the mode's shape: at the @var{times} (1-by-m, s, from
## the start on), by the integrator of that @var{name} in steps of @var{h} (s); NaN where the integration fails.
## @end deftypefn

function found = mode_amplitudes (system, mode, name, h, times)
  solver = struct ("name", name, "tolerance", 1, "step", h);
  found = NaN (size (times));
  try
    [states, moved] = both_motions (system, mode.shape, times, solver);
    found = mode.amplitude (moved, states);
  catch err
    rethrow_others (err, "toolchain:integration");
  end_try_catch
endfunction

## from the start and from a little beside it, at once where the method calls rates, which take a column a state
function [states, moved] = both_motions (system, beside, times, solver)
  table = integrator_table (system.forms);
  if (strcmp (table(strcmp ({table.name}, solver.name)).form, "rate"))
    n = numel (system.initial_state);
    pair = setfield (system, "initial_state", [system.initial_state; system.initial_state + beside]);
    pair.rate = @(t, y) system.rate ([t, t], reshape (y, n, 2))(:);
    both = integrate (pair, times, solver);
    states = both(1:n,:);
    moved = both(n+1:end,:);
  else
    states = integrate (system, times, solver);
    system.initial_state += beside;
    moved = integrate (system, times, solver);
  endif
endfunction

%!function parts = amplitudes (name, h_omega, steps)   # of the rod's highest mode, of what it starts with
%!  system = setfield (free_rod ([2 2], struct ("phi", 0.3)), "duration", 1);
%!  mode = highest_mode (system);
%!  y = system.initial_state;
%!  parts = mode_amplitudes (system, mode, name, h_omega/mode.omega, steps*h_omega/mode.omega);
%!  parts ./= mode.amplitude (y + mode.shape, y);
%!endfunction
%!assert (amplitudes ("rk4", 2, [0 10 20]), abs (polyval (stability_function ("rk4"), 2i)).^[0 10 20], 1e-3)
%!assert (amplitudes ("stormer_verlet", 0.05, [0 10 40]), [1 1 1], 1e-2)   # which takes no rates
%!assert (amplitudes ("rk4", 20, [0 300]), [NaN NaN])   # it fails
