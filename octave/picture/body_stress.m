## -*- texinfo -*-
## @deftypefn {} {[@var{stress}, @var{range}, @var{unit}] =} body_stress (@var{bodies})
## The @var{stress} of each body in @var{unit} (a cell array), and the @var{range} (1-by-2) of all of them in all
## frames, from 0 on. Without any stress, @var{range} is [0 1].
## @end deftypefn

function [stress, range, unit] = body_stress (bodies)
  all_values = cellfun (@(values) values(:), {bodies.stress}, "UniformOutput", false);
  all_values = vertcat (0, all_values{:});
  [scale, unit] = unit_prefix (all_values, "Pa");
  stress = cellfun (@(values) values / scale, {bodies.stress}, "UniformOutput", false);
  range = [min(all_values), max(all_values)] / scale;
  if (range(1) == range(2))
    range = [0 1];
  endif
endfunction

%!test <two bodies, one without a stress>
%! [stress, range, unit] = body_stress (struct ("stress", {[1e6 3e6], []}));
%! assert (stress, {[1 3], []});
%! assert (range, [0 3]);
%! assert (unit, "MPa");
%!test
%! [~, range] = body_stress (struct ("stress", {[]}));
%! assert (range, [0 1]);
