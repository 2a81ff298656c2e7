## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} history_panels (@var{drawing})
## What the history of @var{drawing} (see @code{draw_pictures}) shows, from top to bottom: a struct array of
## @code{label}, of the @code{names} of the curves (1-by-n cell array), and of their @code{values} (n-by-F) in the unit
## that the label names.
## @end deftypefn

function panels = history_panels (drawing)
  history = drawing.history;
  panels = new_panel ("angles", rad2deg ([history.phi; history.psi]), "°", {"φ", "ψ"});

  [along, across] = tip_deflection (drawing);
  panels(end+1) = new_panel ("tip from tangent", [along; across], "m", {"along", "across"});

  [modes, names] = largest_modes (history.V, history.V_names, 4);
  if (! isempty (names))
    panels(end+1) = new_panel ("largest modes", modes, "m", names);
  endif

  energies = [history.T; history.U; history.Z; history.W; history.D];
  panels(end+1) = new_panel ("energies", energies, "J", {"T", "U", "Z", "W", "D"});

  balance = history.T + history.U + history.Z + history.D - history.W;
  panels(end+1) = new_panel ("energy balance", balance - balance(1), "J", {"T+U+Z+D−W"});
endfunction

function panel = new_panel (label, values, unit, names)
  if (! strcmp (unit, "°"))
    [scale, unit] = unit_prefix (values, unit);
    values /= scale;
  endif
  panel = struct ("label", [label ", " unit], "names", {names}, "values", values);
endfunction

%!test
%! panels = history_panels (sample_drawing (10));
%! assert (numel (panels), 5);
%! assert (panels(1).values(1), -30, 1e-12);
%! assert (panels(3).label, "largest modes, µm");
%! assert (panels(5).values(1), 0);
%!test # a rigid rod
%! drawing = sample_drawing (10);
%! drawing.history.V = zeros (0, 10);
%! drawing.history.V_names = {};
%! assert (numel (history_panels (drawing)), 4);
