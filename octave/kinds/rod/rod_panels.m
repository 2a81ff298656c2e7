## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} rod_panels (@var{history}, @var{length})
## What @file{history.svg} shows of a rod of a @var{length} (m) that was observed by @code{measure}, from top to
## bottom: a struct array of panels (see @code{new_panel}).
## @end deftypefn

function panels = rod_panels (history, length)
  panels = new_panel ("angles", "°", {"φ", "ψ"}, rad2deg ([history.phi; history.psi]));
  if (! isempty (history.V))
    [along, across] = tip_deflection (history, length);
    panels(end+1) = new_panel ("tip from tangent", "m", {"along", "across"}, [along; across]);
    [modes, names] = largest_modes (history.V, history.V_names, 4);
    if (! isempty (names))
      panels(end+1) = new_panel ("largest modes", "m", names, modes);
    endif
  endif
  panels = [panels, energy_panels(history)];
endfunction

%!test
%! panels = rod_panels (sample_history (10), 1);
%! assert (numel (panels), 5);
%! assert (panels(1).values(1), -30, 1e-12);
%! assert (panels(3).names{1}, "V2_1");
%! assert (panels(5).values(1), 0);
%!test # a rigid rod
%! history = sample_history (10);
%! history.V = zeros (0, 10);
%! history.V_names = {};
%! assert (numel (rod_panels (history, 1)), 3);
%!test # angles in degrees, the tip, and the modes as they are
%! history = sample_history (10);
%! panels = rod_panels (history, 1);
%! assert (panels(1).values, rad2deg ([history.phi; history.psi]), 1e-12);
%! [along, across] = tip_deflection (history, 1);
%! assert (panels(2).values, [along; across]); assert (panels(3).values(1,:), history.V(3,:));
%! assert ({panels.label}, {"angles", "tip from tangent", "largest modes", "energies", "energy balance"});
%! assert ({panels.unit}, {"°", "m", "m", "J", "J"});
