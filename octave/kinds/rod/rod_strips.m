## -*- texinfo -*-
## @deftypefn {} {@var{strips} =} rod_strips (@var{history}, @var{moment}, @var{length})
## The panels (see @code{new_panel}) beside each frame of a hinged rod, of its @var{history} (see @code{measure}) and
## the @var{moment} at O (1-by-F, N m); without one it is the tip's deflection, for the @var{length} (m), along or
## across the tangent, whichever is larger.
## @end deftypefn

function strips = rod_strips (history, moment, length)
  strips = new_panel ("φ", "°", {"φ"}, rad2deg (history.phi));
  strips(2) = new_panel ("dφ/dt", "rad/s", {"dφ/dt"}, history.phi_dot);
  if (any (moment))
    strips(3) = new_panel ("M", "N m", {"M"}, moment);
  elseif (! isempty (history.V))
    [along, across] = tip_deflection (history, length);
    strips(3) = new_panel ("tip across the tangent", "m", {"tip"}, across);
    if (max (abs (along)) > max (abs (across)))
      strips(3) = new_panel ("tip along the tangent", "m", {"tip"}, along);
    endif
  endif
endfunction

%!assert ({rod_strips(sample_history (3), [0 1 2], 1).label}, {"φ", "dφ/dt", "M"})
%!assert (rod_strips (sample_history (3), [0 0 0], 1)(3).label, "tip across the tangent")
%!test # a rod that is only stretched
%! history = setfield (setfield (sample_history (3), "psi", [0 0 0]), "tip_x", [1 1.1 1.2]);
%! history.tip_y = [0 0 0];
%! assert (rod_strips (history, [0 0 0], 1)(3).values, [0 0.1 0.2], 1e-12);
%!test # their values and units
%! history = sample_history (3);
%! strips = rod_strips (history, [0 1 2], 1);
%! assert ({strips.values}, {rad2deg(history.phi), history.phi_dot, [0 1 2]});
%! assert ({strips.unit}, {"°", "rad/s", "N m"});
%! across = nthargout (2, @tip_deflection, history, 1);
%! assert (rod_strips (history, [0 0 0], 1)(3).values, across);
%! history.V = zeros (0, 3);
%! assert (numel (rod_strips (history, [0 0 0], 1)), 2);
