## -*- texinfo -*-
## @deftypefn {} {} stop_integration (@var{method}, @var{system}, @var{t}, @var{h}, @var{what}, @var{remedy})
## The error of an integration by @var{method} that cannot go on from the time @var{t} (s) of system.duration:
## @var{what} happened, with the step @var{h} (s, NaN: not known), the highest frequency of the linear system and the
## method's limit of stability, if it has one (see @code{stability_limit}), and what to try.
## @end deftypefn

function stop_integration (method, system, t, h, what, remedy)
  omega = highest_frequency (system);
  limit = stability_limit (method);
  text = sprintf ("%s stopped at t = %.6g s of %g s: %s: ", method, t, system.duration, what);
  if (isnan (h))
    text = sprintf ("%sthe highest frequency is %.4g rad/s", text, omega);
  else
    text = sprintf ("%sa step of %.2g s times the highest frequency, %.4g rad/s, is %.3g", text, h, omega, h*omega);
  endif
  if (isfinite (limit) && omega > 0)
    text = sprintf ("%s where the method is stable below %.4g", text, limit);
    remedy = sprintf ("steps below %.2g s, %s", limit/omega, remedy);
  endif
  error ("toolchain:integration", "%s; try %s, fewer modes or another solver\n", text, remedy);
endfunction

%!error <rk4 stopped at t = 0.5 s of 2 s: no number: a step of 0.1 s times the highest frequency, 100 rad/s, is 10 where the method is stable below 2.828; try steps below 0.028 s, rest,>
%! stop_integration ("rk4", struct ("stiffness", 1e4, "mass", 1, "duration", 2), 0.5, 0.1, "no number", "rest");
