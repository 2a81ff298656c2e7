## -*- texinfo -*-
## @deftypefn {} {[@var{along}, @var{across}] =} tip_deflection (@var{drawing})
## How far (1-by-F, m) the tip has moved @var{along} and @var{across} the tangent at O, against the undeformed body laid
## along that tangent. @var{drawing} is that of @code{draw_pictures}.
## @end deftypefn

function [along, across] = tip_deflection (drawing)
  history = drawing.history;
  body = drawing.bodies(end);
  hinge = complex (drawing.hinges.x(1,:), drawing.hinges.y(1,:));
  tip = (complex (history.tip_x, history.tip_y) - hinge) .* exp (-1i * history.psi);
  rest = (complex (body.rest_x(end,:), body.rest_y(end,:)) - hinge) .* exp (-1i * history.phi);
  along = real (tip - rest);
  across = imag (tip - rest);
endfunction

%!test # the chord of a half wave stays behind the tangent
%! drawing = sample_drawing (20);
%! [along, across] = tip_deflection (drawing);
%! angle = drawing.history.psi - drawing.history.phi;
%! assert (across, -sin (angle), 1e-12);
%! assert (along, cos (angle) - 1, 1e-12);
