## -*- texinfo -*-
## @deftypefn {} {@var{forces} =} forces_of_markers (@var{mechanism}, @var{at}, @var{F})
## Generalized forces (n-by-k) of forces and moments on the markers, @var{F} = struct of x, y (N), angle (N m; markers-by-k),
## in the states that @var{at} came from (see @code{marker_motion}).
## @end deftypefn

function forces = forces_of_markers (mechanism, at, F)
  k = columns (F.x);
  forces = zeros (mechanism.n, k);
  for part = at.parts
    part = part{1};
    i = part.numbers;
    on_bodies = part.x_q.*reshape (F.x(i,:), 1, []) + part.y_q.*reshape (F.y(i,:), 1, []) ...
                + part.angle_q.*reshape (F.angle(i,:), 1, []);
    forces(part.index,:) += reshape (on_bodies, [], k);
  endfor
endfunction
