## -*- texinfo -*-
## @deftypefn {} {} refuse_dependent (@var{system}, @var{t}, @var{jacobian})
## An error that names the joints whose constraints depend on those of the others at the time @var{t} (s), by the rank
## of their @var{jacobian}; nothing where there are none and t is 0.
## @end deftypefn

function refuse_dependent (system, t, jacobian)
  [~, R, order] = qr (full (jacobian.'), 0);
  sizes = abs (diag (R));
  rank = sum (sizes > 1e-10*max ([sizes; 0]));
  spare = order(rank+1:end);
  if (! isempty (spare))
    names = unique (system.mechanism.constraints.names(spare));
    scene_error ("at t = %g s %d of %d constraints depend on the others, those of %s: %s", t, numel (spare), ...
                 rows (jacobian), strjoin (names, ", "), "take a joint of another kind there, or none");
  elseif (t > 0)
    stop_integration ("mechanism", system, t, system.duration, NaN, "its equations have no unique solution", ...
                      "other joints");
  endif
endfunction

%!error <at t = 0 s 1 of 2 constraints depend on the others, those of (elbow|knee): take a joint>
%! names.constraints.names = {"elbow", "knee"};
%! refuse_dependent (struct ("mechanism", names, "duration", 1), 0, sparse ([1 2; 2 4]));
