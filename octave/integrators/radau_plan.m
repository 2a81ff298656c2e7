## -*- texinfo -*-
## @deftypefn {} {@var{plan} =} radau_plan (@var{plan}, @var{window}, @var{panels}, @var{kept})
## The next window of @code{integrate_radau}, after a @var{window} (see @code{radau_window}) of so many @var{panels} of
## which so many are @var{kept}: twice as many while Newton's iteration converges well, half as many where it does not.
##
## Windows of many short panels that converge fast go further in a second than those of a few long ones, which turn or
## vibrate too much for one matrix each; none is much longer than one that did not converge.  Where even few panels do
## not converge, the next windows (as many as there is patience) have every stage's matrix.
##
## @var{plan}: h (s, the panels' length), panels, most (of them), reach (s, the longest window), whole (how many
## windows still have every stage's matrix) and patience.
## @end deftypefn

function plan = radau_plan (plan, window, panels, kept)
  if (! window.converged)
    plan = shorter (plan, panels);
    return;
  endif
  plan.reach *= 1.1;
  if (kept < panels)
    plan.h *= min (0.8, max (0.1, 0.85*window.error_ratio(kept+1)^(-1/6)));
    return;
  endif
  by_error = max (0.3, 0.85*max ([window.error_ratio, 1e-12])^(-1/6));
  by_iterations = [2 2 2 2 1.5 1.2 1.1 1 1 0.9 0.8](min (window.iterations, 11));
  plan.h *= min (by_error, by_iterations);
  if (plan.whole)
    plan.whole--;
    plan.panels = min (2*panels, 4);
  elseif (window.iterations < 7)
    plan.panels = max (1, min ([2*panels, plan.most, floor(plan.reach/plan.h)]));
  endif
endfunction

function plan = shorter (plan, panels)
  plan.reach = 0.6*panels*plan.h;
  if (panels > 4)
    plan.panels = ceil (panels/2);
  elseif (! plan.whole)
    plan.whole = plan.patience;
    plan.patience = min (2*plan.patience, 64);
  elseif (panels > 1)
    plan.panels = 1;
  else
    plan.h /= 4;
  endif
endfunction

%!function plan = next (varargin)   # after a window of 8 panels of 0.1 s, that converged as the fields say
%!  window = struct ("converged", true, "iterations", 3, "error_ratio", 0.5*ones (1, 8));
%!  plan = struct ("h", 0.1, "panels", 8, "most", 100, "reach", Inf, "whole", 0, "patience", 4);
%!  plan = radau_plan (plan, setfield (window, varargin{:}), 8, 8);
%!endfunction
%!test # more and longer panels where it converges fast, as the error lets them be; fewer where it does not
%! plan = next ("iterations", 3);
%! assert ([plan.panels, plan.h], [16, 0.085*0.5^(-1/6)], 1e-12);
%! assert (next ("iterations", 11).h, 0.08, 1e-12); assert (next ("iterations", 11).panels, 8);
%! assert (next ("error_ratio", 4).h, 0.085*4^(-1/6), 1e-12);
%!test # and then not much longer than what did not
%! plan = next ("converged", false);
%! assert ([plan.panels, plan.reach], [4, 0.48], 1e-12);
%! plan = radau_plan (plan, struct ("converged", true, "iterations", 3, "error_ratio", 0.5), 4, 4);
%! assert (plan.panels*plan.h <= 0.48*1.1); assert (plan.panels, 5);
%!test # four panels that do not converge have every stage's matrix, then one panel has, and then it is shorter
%! bad = struct ("converged", false);
%! plan = radau_plan (next ("converged", false), bad, 4, 0);
%! assert ([plan.panels, plan.whole, plan.patience], [4 4 8]);
%! plan = radau_plan (plan, bad, 4, 0);
%! assert ([plan.panels, plan.whole, plan.h], [1 4 0.1]);
%! assert (radau_plan (plan, bad, 1, 0).h, 0.025, 1e-15);
