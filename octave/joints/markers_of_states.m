## -*- texinfo -*-
## @deftypefn {} {@var{at} =} markers_of_states (@var{mechanism}, @var{q}, @var{v})
## The motion of a @var{mechanism}'s markers (see @code{marker_motion}) in the states @var{q}, @var{v} (n-by-k).
## @end deftypefn

function at = markers_of_states (mechanism, q, v)
  at = marker_motion (mechanism, columns (q), @(group) motion_of_group (group, q, v));
endfunction

%!test
%! [system, q, v] = sample_state ();
%! at = markers_of_states (system.mechanism, [q q], [v 2*v]);
%! assert (at.x_dot(:,2), 2*at.x_dot(:,1), 1e-12); assert (at.x(:,2), at.x(:,1));
