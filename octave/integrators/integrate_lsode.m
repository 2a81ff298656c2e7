## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_lsode (@var{formulas}, @var{system}, @var{times}, @var{y}, @
##   @var{solver})
## LSODE (Hindmarsh, 1983) with the @var{formulas} of Adams ("adams", order up to 12) or backward differences ("bdf",
## up to 5), through all @var{times} (1-by-m, s) from the state @var{y}, with @var{solver}.tolerance in units of the
## state's scale; with @var{solver}.order all steps have this order and the length @var{solver}.step, whatever their
## error.  @var{steps} is not known: NaN.
## @end deftypefn

function [states, steps] = integrate_lsode (formulas, system, times, y, solver)
  steps = NaN;
  settings = lsode_settings ();
  unwind_protect
    lsode_options ("integration method", formulas);
    lsode_options ("step limit", 1e6);
    lsode_options ("relative tolerance", max (solver.tolerance, 100*eps));
    lsode_options ("absolute tolerance", max (solver.tolerance*system.state_scale, realmin));
    if (isfield (solver, "order"))
      lsode_options ("relative tolerance", 1e10);
      lsode_options ("absolute tolerance", 1e10*system.state_scale);
      lsode_options ("maximum order", solver.order);
      sizes = {"initial step size", "minimum step size", "maximum step size"};
      cellfun (@(name) lsode_options (name, solver.step), sizes);
    endif
    [states, state, message] = told_errors (@(f) lsode (f, y, times, times(end)), @(y, t) system.rate (t, y));
  unwind_protect_cleanup
    cellfun (@lsode_options, settings(:,1), settings(:,2));
  end_unwind_protect
  finite = all (isfinite (states), 2);
  if (state != 2 || ! all (finite))
    reached = times(find ([true; any(diff (states(finite,:)), 2)], 1, "last"));
    causes = struct ("c1", "its step limit was reached", "c4", "its steps shrank to nothing", ...
                     "c5", "its Newton iteration did not converge");
    cause = strtrim (message);
    if (isfield (causes, sprintf ("c%d", -state)))
      cause = causes.(sprintf ("c%d", -state));
    endif
    stop_integration (["lsode_" formulas], system, reached, NaN, cause, ...
                      sprintf ("a larger tolerance than %.2g m", solver.tolerance));
  endif
  states = states.';
endfunction

function settings = lsode_settings ()
  names = {"integration method"; "step limit"; "relative tolerance"; "absolute tolerance"; "maximum order"; ...
           "initial step size"; "minimum step size"; "maximum step size"};
  settings = [names, cellfun(@(name) lsode_options (name), names, "uniformoutput", false)];
endfunction

%!test # a scene's step is for methods of equal steps: here it changes nothing
%! system = struct ("rate", @(t, y) [y(2); -y(1)], "state_scale", [1; 1]);
%! solver = struct ("tolerance", 1e-6, "step", 0.5);
%! assert (integrate_lsode ("bdf", system, [0 1], [1; 0], solver)(:,2), [cos(1); -sin(1)], 1e-4);
%!test # an oscillation by both, to ten times the tolerance, and the user's settings come back
%! before = lsode_options ("relative tolerance");
%! system = struct ("mass", 1, "stiffness", 1, "state_scale", [1; 1], "rate", @(t, y) [y(2); -y(1)]);
%! for formulas = {"adams", "bdf"}
%!   states = integrate_lsode (formulas{1}, system, [0 1 2], [1; 0], struct ("tolerance", 1e-8));
%!   assert (states(1,:), cos (0:2), 1e-6);
%! endfor
%! assert (lsode_options ("relative tolerance"), before);
%!error <lsode_bdf stopped at t = \d[.0-9]* s of 2 s: its>
%! system = struct ("mass", 1, "stiffness", 0, "state_scale", 1, "duration", 2, "rate", @(t, y) y^2);
%! integrate_lsode ("bdf", system, 0:0.5:2, 1, struct ("tolerance", 1e-8));
%!error <the moment is lost>
%! system = struct ("mass", 1, "stiffness", 0, "state_scale", 1, "rate", @(t, y) error ("the moment is lost"));
%! integrate_lsode ("adams", system, 0:2, 1, struct ("tolerance", 1e-8));
