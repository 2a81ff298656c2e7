## -*- texinfo -*-
## @deftypefn {} {@var{F} =} reactions (@var{mechanism}, @var{constraints}, @var{c}, @var{lambda})
## What the multipliers @var{lambda} (constraints-by-k) of the @var{constraints} (see @code{list_constraints}) do to
## the markers, Phi_q' lambda: a struct of x, y, angle (markers-by-k; see @code{forces_of_markers}).  @var{c} comes
## from @code{joint_constraints}.  The joints' forces on the bodies are minus that.
## @end deftypefn

function F = reactions (mechanism, constraints, c, lambda)
  blank = zeros (mechanism.marker_count, columns (lambda));
  F.x = F.y = F.angle = blank;
  for i = 1:numel (c.gradients)
    kind = constraints.kinds(i);
    g = c.gradients{i};
    own = lambda(kind.rows,:);
    for coordinate = kind.coordinates
      to = kind.to_first;
      if (coordinate > 3)
        to = kind.to_second;
      endif
      part = {"x", "y", "angle"}{mod(coordinate - 1, 3) + 1};
      F.(part) += to*(g{coordinate}.*own);
    endfor
  endfor
endfunction

%!test # they do no work where the velocities meet the constraints
%! [system, q, v] = sample_state ();
%! v = project_velocities (system, 0, q, v);
%! at = system.at (0, q, v);
%! assert (system.reaction (at, rand (5, 1)).'*v, 0, 1e-10);
