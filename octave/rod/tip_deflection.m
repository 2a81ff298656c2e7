## -*- texinfo -*-
## @deftypefn {} {[@var{along}, @var{across}] =} tip_deflection (@var{history}, @var{length})
## How far (1-by-F, m) the tip of a rod hinged at the origin has moved @var{along} and @var{across} the tangent at O,
## against where the tip of the undeformed rod, laid along that tangent, is: @var{length} (m), or a complex number of a
## curved rod (see @code{undeformed_tip}). @var{history} is that of @code{measure}.
## @end deftypefn

function [along, across] = tip_deflection (history, length)
  tip = complex (history.tip_x, history.tip_y) .* exp (-1i * history.psi) - length;
  along = real (tip);
  across = imag (tip);
endfunction

%!test # the chord of a half wave stays behind the tangent
%! history = sample_history (20);
%! [along, across] = tip_deflection (history, 1);
%! angle = history.psi - history.phi;
%! assert (across, -sin (angle), 1e-12);
%! assert (along, cos (angle) - 1, 1e-12);
