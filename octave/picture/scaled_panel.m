## -*- texinfo -*-
## @deftypefn {} {[@var{label}, @var{values}] =} scaled_panel (@var{panel})
## The @var{label} with its unit, and the @var{values} (n-by-F) in that unit, of a panel (see @code{new_panel}):
## lengths, energies and moments take the prefix that keeps their numbers short.
## @end deftypefn

function [label, values] = scaled_panel (panel)
  values = drawable (panel.values);
  unit = panel.unit;
  if (any (strcmp (unit, {"m", "J", "N", "N m", "Pa", "s"})))
    [scale, unit] = unit_prefix (values, unit);
    values /= scale;
  endif
  label = panel.label;
  if (! isempty (unit))
    label = [label ", " unit];
  endif
endfunction

%!test
%! [label, values] = scaled_panel (new_panel ("tip", "m", {"x"}, [1e-6 3e-5]));
%! assert (label, "tip, µm");
%! assert (values, [1 30], 1e-12);
%!assert (scaled_panel (new_panel ("rate", "rad/s", {"x"}, 1e-6)), "rate, rad/s")
%!assert (scaled_panel (new_panel ("ratio", "", {"x"}, 1)), "ratio")
