## -*- texinfo -*-
## @deftypefn {} {[@var{tip}, @var{phi}] =} precision_errors (@var{history}, @var{reference})
## The largest errors of the tip (m) and of the hinge angle (rad) of a @var{history} against a @var{reference} (see
## @code{measure}), over the frames that the history has.
## @end deftypefn

function [tip, phi] = precision_errors (history, reference)
  k = 1:numel (history.t);
  tip = max (hypot (history.tip_x - reference.tip_x(k), history.tip_y - reference.tip_y(k)));
  phi = max (abs (history.phi - reference.phi(k)));
endfunction

%!test # over the frames of a run that was given up
%! reference = struct ("t", 1:3, "tip_x", [1 2 3], "tip_y", [0 0 0], "phi", [0 0 0]);
%! history = struct ("t", 1:2, "tip_x", [1 2.3], "tip_y", [0 0.4], "phi", [0 -1]);
%! [tip, phi] = precision_errors (history, reference);
%! assert ([tip, phi], [0.5, 1], 1e-15);
