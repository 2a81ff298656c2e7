## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} rod_at_rest (@var{model}, @var{system})
## The balance of forces of a @var{model} of one rod, whose @var{system} is of @code{hinged_rod} or @code{hub_rod}, for
## @code{equilibrium}: fields as in @code{mechanism_at_rest}, of its coordinates, with phi where it is hinged.
## @end deftypefn

function balance = rod_at_rest (model, system)
  n = rows (system.mass);
  balance.n = n;
  balance.multipliers = 0;
  balance.start = system.initial_state(1:n);
  balance.residual = @(t, q, v, lambda) system.forces (t*ones (1, columns (q)), q, v);
  balance = with_derivatives (balance, 1e-4*model.length*system.state_scale(1:n));
  balance.mass = @(q) system.mass;
  balance.size = @(step) max (abs (step)./system.state_scale(1:n));
  balance.length = model.length;
endfunction

%!test # a rigid rod of 1 m and 1 kg: its weight turns it, and it hangs
%! scene.rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1, "rhoI", 0);
%! [scene.duration, scene.model] = deal (1, struct ("modes", [0 0], "rotary_inertia", false));
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! balance = rod_at_rest (model, rod_system (scene, model));
%! assert (balance.residual (0, 0, 0, []), -9.81/2, 1e-12); assert (balance.tangent (0, -pi/2, []), 9.81/2, 1e-8);
%! assert (equilibrium (balance, 0), -pi/2, 1e-9);
