## -*- texinfo -*-
## @deftypefn {} {[@var{label}, @var{values}] =} scaled_panel (@var{panel})
## The @var{label} with its unit, and the @var{values} (n-by-F) in that unit, of a panel (see @code{new_panel}):
## lengths, energies and moments take the prefix that keeps their numbers short, and lengths and angles are zero
## where they are rounding.
## @end deftypefn

function [label, values] = scaled_panel (panel)
  values = drawable (panel.values);
  unit = panel.unit;
  rounding = [1e-15, 1e-12](strcmp (unit, {"m", "°"}));
  if (! isempty (rounding))
    values(abs (values) < rounding) = 0;
  endif
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
%!assert (nthargout (2, @scaled_panel, new_panel ("angle", "°", {"x"}, [1e-14 2])), [0 2])
%!assert (scaled_panel (new_panel ("tip", "m", {"x"}, 1e-24)), "tip, m")
%!assert (scaled_panel (new_panel ("rate", "rad/s", {"x"}, 1e-6)), "rate, rad/s")
%!assert (scaled_panel (new_panel ("ratio", "", {"x"}, 1)), "ratio")
