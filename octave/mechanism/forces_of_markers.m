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
    row = @(f) reshape (f(part.numbers,:), 1, []);
    on_bodies = part.x_q.*row (F.x) + part.y_q.*row (F.y) + part.angle_q.*row (F.angle);
    forces(part.index,:) += reshape (on_bodies, [], k);
  endfor
endfunction
