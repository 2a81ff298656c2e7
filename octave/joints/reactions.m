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
    F.x += kind.to_first*(g{1}.*own) + kind.to_second*(g{4}.*own);
    F.y += kind.to_first*(g{2}.*own) + kind.to_second*(g{5}.*own);
    F.angle += kind.to_first*(g{3}.*own) + kind.to_second*(g{6}.*own);
  endfor
endfunction

%!test # they do no work where the velocities meet the constraints
%! [system, q, v] = sample_state ();
%! v = project_velocities (system, 0, q, v);
%! at = system.at (0, q, v);
%! assert (system.reaction (at, rand (5, 1)).'*v, 0, 1e-10);
