## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} published_modes (@var{scene}, @var{n})
## The slowest @var{n} frequencies (rad/s) of a scene about its equilibrium (see @code{natural_modes}), for the tests
## of this file.
## @end deftypefn

function omega = published_modes (scene, n)
  kind = kind_of (scene_at_rest (scene));
  scene = kind.check (scene_at_rest (scene));
  omega = at_rest (kind, scene, 0, @(found) found.vibrations.omega(1:n)).vibrations.omega(1:n);
endfunction

%!function scene = cantilever (varargin)   # of unit length, mass and EI
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1), "model", ...
%!                         struct ("energy", "uniaxial", "rotary_inertia", false), varargin{:})};
%!  scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!endfunction
%!function D = at_tip (b, mass, inertia)   # EI v'' = W^2 J v', EI v''' = -W^2 m v, of both shapes that a clamp allows
%!  v = [cos(b) - cosh(b), sin(b) - sinh(b)];
%!  v_1 = b*[-sin(b) - sinh(b), cos(b) - cosh(b)];
%!  v_2 = b^2*[-cos(b) - cosh(b), -sin(b) - sinh(b)];
%!  v_3 = b^3*[sin(b) - sinh(b), -cos(b) - cosh(b)];
%!  D = det ([v_2 - inertia*b^4*v_1; v_3 + mass*b^4*v]);
%!endfunction
%!function omega = with_tip (mass, inertia, near)   # Euler and Bernoulli's rod
%!  root = @(k) fzero (@(b) at_tip (b, mass, inertia), near(k,:), optimset ("TolX", 1e-12));
%!  omega = arrayfun (root, 1:rows (near)).^2;
%!endfunction
%!test # a cantilever with as much mass at its tip
%! assert (published_modes (cantilever ("tip_mass", 1), 2), with_tip (1, 0, [1 1.5; 3.5 4.5]), -1e-6);
%! assert (sqrt (with_tip (1, 0, [1 1.5])), 1.2479174, 1e-6);
%!test # and with inertia, of a rigid bar welded across it by its middle
%! scene = cantilever ();
%! scene.bodies{2} = struct ("rod", struct ("length", 0.6, "EA", 1, "EI", 1, "rhoA", 0.5/0.6), "model", ...
%!                           struct ("modes", [0 0], "rotary_inertia", false), "initial", struct ("phi", pi/2));
%! scene.joints{2} = struct ("kind", "weld", "bodies", [1 2], "stations", [1 0.3]);
%! assert (published_modes (scene, 2), with_tip (0.5, 0.5*0.6^2/12, [1 1.8; 2.5 4.2]), -1e-6);

%!test # a free ring without stretching: n (n^2 - 1)/sqrt (n^2 + 1) = 2.68328, 7.58947, 14.55214
%! f = curved_frequencies (360, 1e4, "ring", 40);
%! assert (f(f > 0.1)([1 3 5]).', [2.68328 7.58947 14.55214], 1e-5);

%!function D = clamped_determinant (square, angle)   # of u = u' = u'' = 0 at both ends of an arc that does not stretch
%!  r = roots ([1 0 2 0 1-square 0 square]).';  # Lamb 1888: u^vi + 2 u^iv + (1 - W^2) u'' + W^2 u = 0
%!  ends = [1 + 0*r; r; r.^2];
%!  D = real (det ([ends; ends.*exp(r*angle)])/prod (nonzeros (tril (r.' - r, -1))));
%!endfunction
%!test # a clamped semicircle and a quarter: R^2 W sqrt (rhoA/EI)
%! for arc = {pi, pi/2; [4 5], [20 30]}
%!   W = fzero (@(W) clamped_determinant (W^2, arc{1}), arc{2}, optimset ("TolX", 1e-10));
%!   scene = cantilever ();
%!   scene.bodies{1}.rod = struct ("length", arc{1}, "EA", 1e8, "EI", 1, "rhoA", 1, "curvature", 1);
%!   rod = check_mechanism (scene).bodies(1).rod;
%!   [x, y, theta] = undeformed_places (struct ("axis", rod_axis (rod, 16)), arc{1});
%!   scene.joints{2} = struct ("kind", "weld", "bodies", 1, "stations", arc{1}, "point", [x y]);
%!   assert (published_modes (scene, 1), W, -1e-5);
%! endfor

%!function omega = on_surface (surface, rod, angle)
%!  scene = struct ("surface", surface, "rod", rod, "duration", 1, "gravity", 0, "ends", {{"hinge", "hinge"}}, ...
%!                  "model", struct ("modes", [16 16]));
%!  scene.initial.angle = angle;
%!  omega = published_modes (scene, 3);
%!endfunction
%!test # hinged on a great circle of a sphere: ((k pi/alpha)^2 - 1) sqrt (EI/rhoA)/R^2
%! rod = struct ("length", 0.7, "EA", 1e5, "EI", 0.1, "EI_normal", 0, "rhoA", 3);
%! expected = (((1:3)*pi/1.4).^2 - 1)*sqrt (0.1/3)/0.5^2;
%! assert (on_surface (struct ("name", "sphere", "radius", 0.5), rod, 0), expected, -1e-6);
%!test # hinged on a helix of a cylinder, along a ruling at b = 0: (EI k^4 + S k^2)/rhoA
%! # the surface bends it by n = sin (b)^2/R and twists it by t = sin (2b)/2R: S has the second derivatives by b of
%! # EI_n n^2/2 + GJ t^2/2, and the pull EI_n n^2 + GJ t^2 along it; EI_n sin (2b)^2 + GJ cos (2b)^2 is of n' and t'
%! rod = struct ("length", 0.7, "EA", 1e5, "EI", 0.1, "EI_normal", 0.3, "GJ", 0.2, "rhoA", 3);
%! k = (1:3)*pi/0.7;
%! for b = [0 0.4 pi/4 pi/2]
%!   bending = sin (2*b)^2 + 2*sin (b)^2*cos (2*b) + sin (b)^4;
%!   twisting = cos (2*b)^2 - sin (2*b)^2 + sin (2*b)^2/4;
%!   omega = on_surface (struct ("name", "cylinder", "radius", 0.4), rod, b);
%!   assert (3*omega.^2, 0.1*k.^4 + (0.3*bending + 0.2*twisting)/0.4^2*k.^2, -1e-5);
%! endfor

%!function scene = with_diagonal ()   # three rigid links of 1 m and 1 kg over a fourth, a spring from O to the far joint
%!  link = struct ("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1), ...
%!                 "model", struct ("modes", [0 0], "rotary_inertia", false));
%!  scene.bodies = {link, link, link};
%!  starts = {struct("phi", 2), struct("x", cos (2), "y", sin (2)), struct("x", 1, "phi", 2)};
%!  for k = 1:3
%!    scene.bodies{k}.initial = starts{k};
%!  endfor
%!  pin = @(bodies, stations, x) struct ("kind", "revolute", "bodies", bodies, "stations", stations, "point", [x 0]);
%!  spring = struct ("kind", "spring", "bodies", 3, "stations", 1, "stiffness", 25, "damping", 1, "rest", sqrt (2));
%!  scene.joints = {pin(1, 0, 0), pin([1 2], [1 0], 0), pin([2 3], [1 1], 0), pin(3, 0, 1), spring};
%!  [scene.gravity, scene.duration] = deal (9.81, 1);
%!endfunction
%!test # IFToMM's four-bar linkage with a diagonal spring (library of benchmarks, its solution 120): where it rests
%! phi = 2.23433101898;
%! evalc ("rest = statics (with_diagonal (), 'output', '');");
%! assert (rest.q([1 7]), [phi; phi], 1e-10);
%!test # and how it rings, as its energies in the one angle have it: 5/6 phi_dot^2, 2 g sin (phi) + 25/2 (s - sqrt (2))^2
%! phi = 2.23433101898;
%! [s, s_1, s_2] = deal (2*cos (phi/2), -sin (phi/2), -cos (phi/2)/2);
%! root = roots ([5/3, s_1^2, 25*(s_1^2 + (s - sqrt(2))*s_2) - 2*9.81*sin(phi)])(1);
%! evalc ("mode = natural_modes (with_diagonal (), 'output', '');");
%! assert ([mode.omega, mode.damping], [abs(root), -real(root)/abs(root)], 1e-9);
