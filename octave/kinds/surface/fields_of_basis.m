## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} fields_of_basis (@var{base}, @var{z}, @var{z_dot}, @var{z_ddot}, @var{turn})
## What the surface's generated functions take of the rod's place: the chart's coordinates alpha1 and alpha2, their
## slopes _1, second derivatives _11, rates _dot, second rates _ddot, the slopes of the rates and of the second rates,
## the second derivatives of the rates, and the undeformed rod's curvature kappa, where the @var{base} (see
## @code{surface_basis}) has its stations: a row a station, a column a time.  Where there is a @var{turn}, the base is
## one of a chart that turns so (see @code{turned_fields}).
## @end deftypefn

function fields = fields_of_basis (b, z, z_dot, z_ddot, turn = [])
  fields.alpha1 = b.start_values{1} + b.values{1}*z;
  fields.alpha2 = b.start_values{2} + b.values{2}*z;
  fields.alpha1_1 = b.start_slopes{1} + b.slopes{1}*z;
  fields.alpha2_1 = b.start_slopes{2} + b.slopes{2}*z;
  fields.alpha1_11 = b.start_seconds{1} + b.seconds{1}*z;
  fields.alpha2_11 = b.start_seconds{2} + b.seconds{2}*z;
  fields.alpha1_dot = b.values{1}*z_dot;
  fields.alpha2_dot = b.values{2}*z_dot;
  fields.alpha1_ddot = b.values{1}*z_ddot;
  fields.alpha2_ddot = b.values{2}*z_ddot;
  fields.alpha1_1_dot = b.slopes{1}*z_dot;
  fields.alpha2_1_dot = b.slopes{2}*z_dot;
  fields.alpha1_11_dot = b.seconds{1}*z_dot;
  fields.alpha2_11_dot = b.seconds{2}*z_dot;
  fields.alpha1_1_ddot = b.slopes{1}*z_ddot;
  fields.alpha2_1_ddot = b.slopes{2}*z_ddot;
  fields.kappa = b.kappa(:,ones (1, columns (z)));
  if (! isempty (turn))
    fields.alpha1_11_ddot = b.seconds{1}*z_ddot;
    fields.alpha2_11_ddot = b.seconds{2}*z_ddot;
    fields = turned_fields (fields, turn);
  endif
endfunction

%!test # the start, and what one coordinate adds
%! one = @(x) {x, 0};
%! base = struct ("values", {one(2)}, "slopes", {one(3)}, "seconds", {one(4)}, "start_values", {one(5)}, ...
%!                "start_slopes", {one(6)}, "start_seconds", {one(7)}, "kappa", 8);
%! fields = fields_of_basis (base, 1, 10, 100);
%! assert ([fields.alpha1, fields.alpha1_1, fields.alpha1_11], [7 9 11]);
%! assert ([fields.alpha1_dot, fields.alpha1_ddot, fields.alpha1_1_dot, fields.alpha1_1_ddot], [20 200 30 300]);
%! assert ([fields.alpha1_11_dot, fields.kappa], [40 8]);
