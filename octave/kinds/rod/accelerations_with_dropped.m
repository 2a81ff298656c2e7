## -*- texinfo -*-
## @deftypefn {} {[@var{q_ddot}, @var{torque}] =} accelerations_with_dropped (@var{solved}, @var{t}, @var{q}, @
##   @var{q_dot}, @var{phi}, @var{phi_dot}, @var{c})
## Accelerations (n-by-m) of a straight rod that feel the forces of what its model drops (see @code{dropped_forces}),
## and the @var{torque} on phi among these (1-by-m, N m), at the m times @var{t} and states.  Those forces need
## accelerations, which feel them: from those without them they are taken again and again, until half a hundredth in
## each coordinate changes, ten times at most, with the change that the last two let expect (Anderson, J. ACM 12, 1965,
## of one step back and each coordinate alone).
##
## [q_ddot, phi_ddot] = @var{solved} (force_q, force_phi) are the accelerations with such forces beside all others.
## @var{c} is what @code{rod_constants} gives, with points (see @code{dropped_points}), the model's followers, and
## tangent: whether the moment works on the tangent at O.
## @end deftypefn

function [q_ddot, torque] = accelerations_with_dropped (solved, t, q, q_dot, phi, phi_dot, c)
  [q_ddot, phi_ddot] = solved (0*q, 0*phi);
  felt = [q_ddot; phi_ddot];
  found = change = 0*felt;
  for pass = 1:10
    [before, last] = deal (found, change);
    [more_q, torque] = dropped (t, q, q_dot, felt(1:end-1,:), phi, phi_dot, felt(end,:), c);
    [q_ddot, phi_ddot] = solved (more_q, torque);
    found = [q_ddot; phi_ddot];
    change = found - felt;
    if (all (sum (abs (change), 2)(1:end-1) <= 0.005*sum (abs (q_ddot), 2)))
      return;
    endif
    felt = found;
    if (pass > 1)
      turn = change - last;
      felt -= sum (change.*turn, 2)./max (sum (turn.^2, 2), realmin).*(found - before);
    endif
  endfor
endfunction

function [force_q, force_phi] = dropped (t, q, q_dot, q_ddot, phi, phi_dot, phi_ddot, c)
  none = zeros (1, columns (q));
  motion = struct ("q", q, "q_dot", q_dot, "q_ddot", q_ddot, "phi", phi, "phi_dot", phi_dot, "phi_ddot", phi_ddot, ...
                   "x_ddot", none, "y_ddot", none, "followers", []);
  loads = struct ("gravity", c.gravity, "moment", none, "force_x", none, "force_y", none);
  if (c.tangent)
    loads.moment = c.moment (t);
  endif
  if (! isempty (c.force))
    F = c.force (t);
    loads.force_x = F(1,:);
    loads.force_y = F(2,:);
  endif
  if (! isempty (c.followers))
    motion.followers = rod_followers (motion, c.followers, c.gravity, loads);
  endif
  [force_q, force_phi] = dropped_forces (c.points, motion, loads);
endfunction

%!function [c, q] = bent ()   # what it takes, and coordinates, of two bending modes
%!  scene = setfield (setfield (swing (), "moment", @(t) 300*t), "force", @(t) [20 -30]*t);
%!  scene.model = struct ("modes", [0 2], "stiffening", "foreshortening");
%!  scene = check_scene (scene);
%!  model = build_model (scene, rung_of_scene (scene));
%!  c = setfield (rod_constants (scene, model), "points", dropped_points (model, scene));
%!  c.followers = model.followers;
%!  c.tangent = true;
%!  q = [0.03; 0.005];
%!endfunction
%!function forces = of_accelerations (x, moment, q, c)   # on q and phi, from rest, under what else acts at t = 0.5
%!  loads = struct ("gravity", 9.81, "moment", moment, "force_x", 10, "force_y", -15);
%!  motion = struct ("q", q, "q_dot", 0*q, "q_ddot", x(1:2), "phi", 0.3, "phi_dot", 0, "phi_ddot", x(3), ...
%!                   "x_ddot", 0, "y_ddot", 0, "followers", []);
%!  [force, torque] = dropped_forces (c.points, motion, loads);
%!  forces = [force; torque];
%!endfunction
%!test # forces and accelerations that belong to each other: the first ones are off by a tenth
%! [c, q] = bent ();
%! [m, mm, force_q, force_phi] = rod_forces (0.5, 0.3, 0, q, 0*q, c);
%! x_ddot = @(forces) [c.rod.mass_matrix, m; m.', mm] \ ([force_q; force_phi] + forces);
%! exact = fsolve (@(x) x - x_ddot (of_accelerations (x, 150, q, c)), x_ddot (zeros (3, 1)));
%! solved = @(f, g) deal (x_ddot ([f; g])(1:2), x_ddot ([f; g])(3));
%! [q_ddot, torque] = accelerations_with_dropped (solved, 0.5, q, 0*q, 0.3, 0, c);
%! assert (q_ddot, exact(1:2), 0.01*norm (exact(1:2)));
%! assert (torque, of_accelerations (exact, 150, q, c)(3), -0.01);
%! once = x_ddot (of_accelerations (zeros (3, 1), 150, q, c))(1:2);
%! assert (norm (once - exact(1:2)) > 0.1*norm (exact(1:2)));
%!test # forces are those of the time's loads, the moment where it works on the tangent
%! [c, q] = bent ();
%! found = @(c) accelerations_with_dropped (@(f, g) deal (1e-12*f, 0), 0.5, q, 0*q, 0.3, 0, c)/1e-12;
%! assert (found (c), of_accelerations (zeros (3, 1), 150, q, c)(1:2), 1e-6);
%! assert (found (setfield (c, "tangent", false)), of_accelerations (zeros (3, 1), 0, q, c)(1:2), 1e-6);
%!test # those along the rod, too, beside fast ones across it that are much larger
%! scene = setfield (swing (), "model", struct ("modes", [6 24], "stiffening", "foreshortening"));
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! c = setfield (rod_constants (scene, model), "points", dropped_points (model, scene));
%! [c.followers, c.tangent] = deal (model.followers, true);
%! n = columns (model.basis);
%! omega = sqrt (diag (c.rod.stiffness_matrix)./diag (c.rod.mass_matrix));
%! q = 5e-4*cos ((1:n).')./omega*omega(1);
%! q_dot = 1.5e-4*sin ((1:n).')*omega(1);
%! rate = c.rod.mass_matrix \ (-c.rod.stiffness_matrix*q);
%! free = @(f, g) deal (rate + c.rod.mass_matrix \ f, 0);
%! loads = struct ("gravity", c.gravity, "moment", 0, "force_x", 0, "force_y", 0);
%! motion = @(x) struct ("q", q, "q_dot", q_dot, "q_ddot", x, "phi", 0.3, "phi_dot", 5, "phi_ddot", 0, "x_ddot", 0, ...
%!                       "y_ddot", 0, "followers", []);
%! more = @(x) rate + c.rod.mass_matrix \ dropped_forces (c.points, motion (x), loads);
%! exact = q;
%! for pass = 1:60
%!   exact = more (exact);
%! endfor
%! assert (more (exact), exact, 1e-9*max (abs (exact)));
%! found = accelerations_with_dropped (free, 0.5, q, q_dot, 0.3, 5, c);
%! assert (found, exact, 0.01*abs (exact));
