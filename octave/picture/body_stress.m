## -*- texinfo -*-
## @deftypefn {} {[@var{stress}, @var{range}, @var{unit}] =} body_stress (@var{bodies})
## The @var{stress} of each body in @var{unit} (a cell array of P-by-F or empty), and the @var{range}
## (1-by-2) of all of them in all frames, with 0 in it. When there is none at all, @var{range} is [0 1].
## @end deftypefn

function [stress, range, unit] = body_stress (bodies)
  stress = cellfun (@drawable, {bodies.stress}, "UniformOutput", false);
  values = cellfun (@(values) values(:), stress, "UniformOutput", false);
  values = vertcat (0, values{:});
  [scale, unit] = unit_prefix (values, "Pa");
  stress = cellfun (@(values) values / scale, stress, "UniformOutput", false);
  range = [min(values), max(values)] / scale;
  if (range(1) == range(2))
    range = [0 1];
  endif
endfunction

%!test # two bodies, one without a stress
%! [stress, range, unit] = body_stress (struct ("stress", {[1e6 3e6], []}));
%! assert (stress, {[1 3], []});
%! assert (range, [0 3]);
%! assert (unit, "MPa");
%!test
%! [~, range] = body_stress (struct ("stress", []));
%! assert (range, [0 1]);
