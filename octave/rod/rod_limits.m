## -*- texinfo -*-
## @deftypefn {} {@var{limits} =} rod_limits (@var{scene}, @var{model}, @var{history}, @var{steepest})
## What the @var{model} of one rod holds for, and how much of it a run's @var{history} (V and phi_dot) takes: a struct
## array of what, limit and reached.  It is the slope v2,1, small below the @var{steepest} (0.2), the strain v1,1 and,
## of a hinged rod without foreshortening, the rate of rotation that takes its stiffness: the first frequency of the
## simply supported rod.  @var{scene} has its rod.  The geometrically exact rod needs a small strain only.
## @end deftypefn

function limits = rod_limits (scene, model, history, steepest = 0.2)
  slopes_of = largest_slopes (model);
  [slope, strain] = slopes_of (history.V);
  limits = struct ("what", {"slope v2,1", "strain v1,1"}, "limit", {steepest, 0.01}, "reached", {slope, strain});
  turns = ! isfield (scene, "rotation") || isempty (scene.rotation);
  if (strcmp (model.rung.stiffening, "exact"))
    limits = limits(2);
  elseif (! model.shortening && isempty (scene.rod.curvature) && turns && ! strcmp (rung_name (model.rung), "rigid"))
    limits(end+1) = struct ("what", "rate of rotation [rad/s] without foreshortening", ...
                            "limit", simply_supported_frequency (scene, model), ...
                            "reached", max (abs (history.phi_dot)));
  endif
endfunction

%!function limits = of (stiffening, V)
%!  [scene, model] = sample_rod ([1 1], "model.stiffening", stiffening);
%!  limits = rod_limits (scene, model, struct ("V", V, "phi_dot", [3 -5]), 0.2);
%!endfunction
%!test # slope and strain of sines, and the rate at which the first has no stiffness left
%! limits = of ("none", [1e-3; -0.02]);
%! assert ([limits.limit](1:2), [0.2 0.01]);
%! [scene, model] = sample_rod ([1 1]);
%! assert ([limits.reached], [0.02*pi, 1e-3*pi/2, 5]./scene.rod.length.^[1 1 0], 1e-12);
%! assert (limits(3).limit, simply_supported_frequency (scene, model));
%! assert (numel (of ("foreshortening", [0; 0])), 2);
