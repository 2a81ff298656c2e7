## -*- texinfo -*-
## @deftypefn {} {@var{forces} =} forces_of_markers (@var{mechanism}, @var{at}, @var{F})
## Generalized forces (n-by-k) of forces and moments on the markers, @var{F} = struct of x, y (N), angle (N m;
## markers-by-k), in the states that @var{at} came from (see @code{marker_motion}).  Joints
## do nothing to what they do not see.
## @end deftypefn

function forces = forces_of_markers (mechanism, at, F)
  k = columns (F.x);
  forces = zeros (mechanism.n, k);
  for part = at.parts
    part = part{1};
    i = part.numbers;
    x = reshape (F.x(i,:), 1, []);
    y = reshape (F.y(i,:), 1, []);
    angle = reshape (F.angle(i,:), 1, []);
    on_bodies = [part.x_V.*x + part.y_V.*y + part.angle_V.*angle; part.x_phi.*x + part.y_phi.*y + angle; x; y];
    forces(part.index,:) += reshape (on_bodies, [], k);
  endfor
endfunction

%!test # power of the generalized forces is that of the forces on the points
%! [system, q, v] = sample_state ();
%! at = markers_of_states (seen_whole (system.mechanism), q, v);
%! F = struct ("x", rand (size (at.x)), "y", rand (size (at.x)), "angle", rand (size (at.x)));
%! power = sum (F.x.*at.x_dot + F.y.*at.y_dot + F.angle.*at.angle_dot);
%! assert (forces_of_markers (system.mechanism, at, F).'*v, power, 1e-12*abs (power));
