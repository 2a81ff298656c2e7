## -*- texinfo -*-
## @deftypefn {} {@var{label} =} rung_label (@var{rung})
## What a @var{rung} is called in a chart: bending modes, with q where longitudinal ones are quasi-static, + their
## number where they are dynamic.
## @end deftypefn

function label = rung_label (rung)
  label = sprintf ("%d", rung.bending);
  if (! isempty (rung.sines))
    label = sprintf ("%d + %d sines", rung.sines);
  elseif (strcmp (rung.axial, "quasistatic"))
    label = [label "q"];
  elseif (strcmp (rung.axial, "dynamic"))
    label = sprintf ("%s+%d", label, rung.longitudinal);
  endif
endfunction

%!assert (rung_label (struct ("sines", [7 7], "bending", 7)), "7 + 7 sines")
%!assert (rung_label (struct ("sines", [], "bending", 3, "axial", "dynamic", "longitudinal", 2)), "3+2")
