## -*- texinfo -*-
## @deftypefn {} {@var{at} =} marker_motion (@var{mechanism}, @var{q}, @var{v})
## Where the markers of a @var{mechanism} are and how they move, in the states @var{q}, @var{v} (n-by-k; k times or
## stages): a struct of x, y, angle, their rates x_dot, y_dot, angle_dot and x_convection, y_convection,
## angle_convection (accelerations without those of the coordinates; markers-by-k), and parts (derivatives by the
## coordinates of each marker group's bodies: index (coordinates-by-bodies), numbers, x_q, y_q, angle_q
## ((coordinates)-by-(bodies k))).
## @end deftypefn

function at = marker_motion (mechanism, q, v)
  k = columns (q);
  blank = zeros (mechanism.marker_count, k);
  at.x = at.y = at.angle = at.x_dot = at.y_dot = at.angle_dot = blank;
  at.x_convection = at.y_convection = at.angle_convection = blank;
  ground = mechanism.ground;
  fixed = ones (1, k);
  at.x(ground.number,:) = ground.x*fixed;
  at.y(ground.number,:) = ground.y*fixed;
  at.angle(ground.number,:) = ground.angle*fixed;
  at.parts = cell (1, numel (mechanism.markers));
  for g = 1:numel (mechanism.markers)
    group = mechanism.markers(g);
    index = mechanism.groups(group.group).index(:,group.columns);
    [R, bodies] = size (index);
    Q = reshape (q(index,:), R, []);
    Q_dot = reshape (v(index,:), R, []);
    [x, y, a, x_dot, y_dot, a_dot, x_c, y_c, a_c, x_phi, y_phi, x_V, y_V, a_V] = rod_marker (
      motion_of_rods (Q, Q_dot), group.marker);
    i = group.numbers;
    at.x(i,:) = reshape (x, bodies, k);
    at.y(i,:) = reshape (y, bodies, k);
    at.angle(i,:) = reshape (a, bodies, k);
    at.x_dot(i,:) = reshape (x_dot, bodies, k);
    at.y_dot(i,:) = reshape (y_dot, bodies, k);
    at.angle_dot(i,:) = reshape (a_dot, bodies, k);
    at.x_convection(i,:) = reshape (x_c, bodies, k);
    at.y_convection(i,:) = reshape (y_c, bodies, k);
    at.angle_convection(i,:) = reshape (a_c, bodies, k);
    one = ones (1, columns (Q));
    none = 0*one;
    at.parts{g} = struct ("index", index, "numbers", i, "x_q", [x_V; x_phi; one; none], ...
                          "y_q", [y_V; y_phi; none; one], "angle_q", [a_V; one; none; none]);
  endfor
endfunction

%!test # rates, convection and derivatives are those of the positions
%! [system, q, v, h] = sample_state ();
%! at = @(q) marker_motion (system.mechanism, q, v);
%! [back, here, on] = deal (at (q - h*v), at (q), at (q + h*v));
%! assert ((on.x - back.x)/(2*h), here.x_dot, 1e-7);
%! assert ((on.y_dot - back.y_dot)/(2*h), here.y_convection, 1e-6);
%! assert ((on.angle_dot - back.angle_dot)/(2*h), here.angle_convection, 1e-5);
%! part = here.parts{1};
%! assert (sum (part.y_q(:,1).*v(part.index(:,1))), here.y_dot(part.numbers(1)), 1e-12);
