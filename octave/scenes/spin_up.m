## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} spin_up ()
## The spin-up manoeuvre of Kane, Ryan and Banerjee (1987): a rod clamped in a hub that is brought to 6 rad/s in 15 s,
## past the clamped rod's first frequency, 3.80 rad/s.  The tip lags by 0.57 m and comes back to the line, about which
## the rod, stiffer as it turns, goes on vibrating at 4.51 rad/s; one or two clamped bending modes are enough for that.
##
## Without foreshortening the tip lags by 0.66 m and vibrates at 3.45 rad/s: the rod softens.  It would lose its
## stiffness at 3.80 rad/s in a frame that is clamped to the hub; the frame here turns with the chord, which shortens
## no rod, so that it would at the simply supported rod's 10.66 rad/s, which the hub never reaches.
## @end deftypefn

function scene = spin_up ()
  scene.title = "Spin-up of a flexible rod, Kane, Ryan and Banerjee (1987)";
  scene.rod.length = 10;
  scene.rod.EA = 2.8e7;
  scene.rod.EI = 1.4e4;
  scene.rod.rhoA = 1.2;
  scene.rod.rhoI = 6e-4;
  scene.gravity = 0;
  scene.rotation = @hub;
  scene.moment_breaks = 15;
  scene.duration = 20;
  scene.frames_per_second = 20;
endfunction

## [theta theta_dot theta_ddot] with theta_dot = 6/15 (t - T sin (t/T)), T = 15/(2 pi), until it is 6
function theta = hub (t)
  T = 15/(2*pi);
  s = min (t, 15);
  theta = 6/15*[s^2/2 + T^2*(cos (s/T) - 1), s - T*sin(s/T), 1 - cos(s/T)];
  theta(1) += 6*(t - s);
endfunction

%!test # the rates are derivatives, and the hub ends at 6 rad/s
%! f = spin_up ().rotation; h = 1e-6;
%! for t = [1 7 14.9 17]
%!   assert ((f (t + h) - f (t - h))(1:2)/(2*h), f (t)(2:3), 1e-6);
%! endfor
%! assert (f (18)(2), 6, 1e-12);
%!test # frequencies at 6 rad/s against Ritz's with (xi/l)^2 to (xi/l)^7: EI v2,11^2 + N v2,1^2 - rhoA Omega^2 v2^2
%! scene = check_scene (spin_up ());
%! rung = struct ("sines", [], "bending", 8, "longitudinal", 0, "axial", "quasistatic");
%! first = @(K, M) sqrt (min (real (eig (K, M))));
%! for kind = {"foreshortening", "none"}
%!   system = hub_rod (scene, model = build_model (scene, setfield (rung, "stiffening", kind{1})));
%!   found.(kind{1}) = first (system.stiffness_at (18, system.initial_state), system.mass);
%! endfor
%! p = (2:7).' + (2:7);
%! bending = 1.4e4*((2:7).*(1:6)).'*((2:7).*(1:6))./(p - 3)/1e3;
%! tension = 0.6*36*(2:7).'*(2:7).*(1./(p - 1) - 1./(p + 1))*10;
%! mass = 1.2*10./(p + 1);
%! assert (first (bending, mass), 3.7977, 1e-3); assert (first (system.stiffness, system.mass), 3.7977, 1e-3);
%! assert (found.foreshortening, first (bending + tension - 36*mass, mass), 1e-3);
%! assert ([found.foreshortening, found.none], [4.51, 3.45], 5e-3);
%! ## without foreshortening the chord's frame has K - phi_dot^2 M
%! assert (first (model.arrays.stiffness_matrix, model.arrays.mass_matrix), 10.66, 5e-3);
