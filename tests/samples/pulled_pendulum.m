## -*- texinfo -*-
## @deftypefn {} {@var{path} =} pulled_pendulum (@var{kind})
## The @var{path} of a rigid pendulum (see @code{path_point}), 1 kg on 1 m, that hangs and that a force of 1 N along x
## at its end, or a "moment" of 1 N m at its hinge, turns.
## @end deftypefn

function path = pulled_pendulum (kind = "force")
  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1), "model", ...
                         struct ("modes", [0 0], "rotary_inertia", false), "initial", struct ("phi", -pi/2))};
  load = struct ("kind", kind, "bodies", 1, "stations", 1, "value", 1);
  if (strcmp (kind, "force"))
    load.value = [1 0];
  endif
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), load};
  scene.duration = 1;
  scene = growing_loads (check_mechanism (scene), 0);
  balance = mechanism_at_rest (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
  path = struct ("balance", balance, "factors", 0:5:20, "range", 20, "size", 1, "mass", 1);
endfunction

%!test # it hangs where nothing pulls
%! path = pulled_pendulum ();
%! assert (path.balance.residual (0, [-pi/2; 0; 0], zeros (3, 1), [0; -9.81]), zeros (5, 1), 1e-12);
