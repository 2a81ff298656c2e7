## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} octave_ode (@var{ode}, @var{system}, @var{rate}, @var{times}, @
##   @var{y}, @var{options}, @var{stages}, @var{tolerance})
## One of Octave's own methods @var{ode} (@code{@@ode45} ...) through all @var{times} (1-by-m, s) from @var{y} (n-by-1),
## with the @var{options} of @code{odeset}: @var{states} (n-by-m), and the @var{steps} tried, so many @var{stages} each.
## One that does not reach the last time is an error that says where it stopped, at which @var{tolerance} (m).
## @end deftypefn

function [states, steps] = octave_ode (ode, system, rate, times, y, options, stages, tolerance)
  reached = [];
  requested = unique ([times, mean(times)]);  # with two times they keep every step, in arrays that they grow one by one
  before = system.calls ();
  try
    [t, states] = quietly (@() ode (rate, requested, y, options));
  catch err
    where = regexp (err.message, '^integrate_adaptive: .* t = (\S+) before', "tokens", "once");
    if (isempty (where))
      rethrow (err);
    endif
    reached = str2double (where{1});  # Octave 7 gives up after 5000 refused steps
  end_try_catch
  steps = round ((system.calls () - before)/stages);
  if (isempty (reached))
    finite = all (isfinite (states), 2);
    if (t(end) < times(end) || ! all (finite))
      reached = max ([t(finite); times(1)]);
    endif
  endif
  if (! isempty (reached))
    stop_integration (func2str (ode), system, reached, (reached - times(1))/max (steps, 1), ...
                      "its steps shrank to nothing", sprintf ("a larger tolerance than %.2g m", tolerance));
  endif
  states = states(ismember (requested, times),:).';
endfunction

%!error <stopped at t = 0.0016 s of 2 s: its steps shrank to nothing: .*; try a larger tolerance than 1e-06 m>
%! system = struct ("mass", 1, "stiffness", 0, "duration", 2, "calls", @() 0);
%! said = "integrate_adaptive: Solving was not successful.  The loop exited at time t = 0.001600 before the endpoint";
%! octave_ode (@(varargin) error (said), system, @(t, y) y, [0 2], 1, odeset (), 6, 1e-6);
%!error <ode45 stopped at t = 0.83\d* s of 2 s> # y = 1/(1 - t)
%! system = struct ("mass", 1, "stiffness", 0, "duration", 2, "calls", @() 0);
%! octave_ode (@ode45, system, @(t, y) y^2, [0 0.5 2], 1, odeset ("AbsTol", 1e-6), 6, 1e-6);
%!error <another fault> octave_ode (@(varargin) error ("another fault"), struct ("calls", @() 0), [], [0 1], 1, [], 6, 1);
