## -*- texinfo -*-
## @deftypefn {} {[@var{Q}, @var{torque}] =} work_on_base (@var{base}, @var{d}, @var{fields}, @var{turn})
## Generalized forces @var{Q} (n-by-m) of virtual work per variation of the chart's coordinates, and of their first and
## second derivatives along the rod, @var{d} (a cell of 2, 4 or 6 densities, p-by-m), where the @var{base} (see
## @code{surface_basis}) has its stations; and where there is a @var{turn} of the chart (see @code{turned_fields}), to
## which the @var{fields} belong, the @var{torque} (1-by-m) about its origin, and, where that moves, the work per its
## two coordinates below it (3-by-m).
## @end deftypefn

function [Q, torque] = work_on_base (b, d, fields, turn)
  torque = 0;
  if (! isempty (turn))
    theta = ones (rows (b.weights), 1)*turn(1,:);
    places = {fields.alpha1, fields.alpha2, fields.alpha1_1, fields.alpha2_1, fields.alpha1_11, fields.alpha2_11};
    moving = [];
    if (rows (turn) == 9)
      places(1:2) = {places{1} - turn(4,:), places{2} - turn(7,:)};
      moving = [b.weights.'*d{1}; b.weights.'*d{2}];
    endif
    for k = 1:2:numel (d)
      [d{k}, d{k+1}, about] = chart_work (theta, places{[k k+1]}, d{[k k+1]});
      torque += b.weights.'*about;
    endfor
    torque = [torque; moving];
  endif
  Q = b.onto{numel (d)/2}*vertcat (d{:});
endfunction

%!test # a force of 1 and 2 at (3, 4), and a couple on the slope, in a chart that has turned by a quarter
%! base = struct ("weights", 1, "onto", {{[1 0], [1 0 0 1], [1 0 0 1 0 0]}});
%! fields = struct ("alpha1", 3, "alpha2", 4, "alpha1_1", 0, "alpha2_1", 1, "alpha1_11", 0, "alpha2_11", 0);
%! [Q, torque] = work_on_base (base, {1, 2, 0.5, 0}, fields, [pi/2; 0; 0]);
%! assert (torque, 3*2 - 4*1 - 0.5, 1e-15);
%! assert (Q, 2 - 0.5, 1e-15);
%! assert (work_on_base (base, {1, 2, 0.5, 3}, fields, []), 1 + 3);
%!test # of a chart whose origin is at (1, 1), too: the torque is about that, and the force works along with it
%! base = struct ("weights", 1, "onto", {{[1 0], [1 0 0 1], [1 0 0 1 0 0]}});
%! fields = struct ("alpha1", 3, "alpha2", 4, "alpha1_1", 0, "alpha2_1", 1, "alpha1_11", 0, "alpha2_11", 0);
%! [~, torque] = work_on_base (base, {1, 2}, fields, [pi/2; 0; 0; 1; 0; 0; 1; 0; 0]);
%! assert (torque, [2*2 - 3*1; 1; 2], 1e-15);
