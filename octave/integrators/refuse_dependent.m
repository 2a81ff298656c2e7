## -*- texinfo -*-
## @deftypefn {} {} refuse_dependent (@var{system}, @var{t}, @var{jacobian}, @var{tolerance})
## An error that names the joints whose constraints depend on those of the others at the time @var{t} (s), by the rank
## of their @var{jacobian} to the @var{tolerance} (default 1e-10): of the scene where t is 0, later of the integration,
## which came to a singular position.  Nothing where no constraints depend on others.
## @end deftypefn

function refuse_dependent (system, t, jacobian, tolerance = 1e-10)
  [~, R, order] = qr (full (jacobian.'), 0);
  sizes = abs (diag (R));
  rank = sum (sizes > tolerance*max ([sizes; 0]));
  spare = order(rank+1:end);
  if (! isempty (spare))
    names = strjoin (unique (system.mechanism.constraints.names(spare)), ", ");
    what = sprintf ("%d of %d constraints depend on the others, those of %s", numel (spare), rows (jacobian), names);
    if (t == 0)
      scene_error ("at t = 0 s %s: take a joint of another kind there, or none", what);
    endif
    stop_integration ("mechanism", system, t, NaN, ["it came to a singular position: " what], ...
                      "a motion that does not come there, or joints that leave it a way on");
  endif
endfunction

%!error <at t = 0 s 1 of 2 constraints depend on the others, those of (elbow|knee): take a joint>
%! names.constraints.names = {"elbow", "knee"};
%! refuse_dependent (struct ("mechanism", names, "duration", 1), 0, sparse ([1 2; 2 4]));
%!error <mechanism stopped at t = 0.5 s of 1 s: it came to a singular position: 1 of 2 constraints .* (elbow|knee):>
%! names.constraints.names = {"elbow", "knee"};
%! system = struct ("mechanism", names, "duration", 1, "stiffness", 0, "mass", 1);
%! refuse_dependent (system, 0.5, sparse ([1 2; 2 4.0001]), 1e-3);
%!test # none depend
%! refuse_dependent (struct ("duration", 1), 0.5, sparse ([1 2; 2 5]), 1e-6);
