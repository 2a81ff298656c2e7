## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} plane_rods (@var{ends}, @var{modes})
## A rod of 1 m, E I = 1 N m^2, on the level plane along the first axis without gravity, for the tests of this file.
## @end deftypefn

function scene = plane_rods (ends, modes)
  scene.surface = struct ("name", "plane", "inclination", 0);
  scene.rod = struct ("length", 1, "EA", 1e7, "EI", 1, "rhoA", 1);
  [scene.ends, scene.model.modes] = deal (ends, modes);
  scene.gravity = 0;
  scene.duration = 1;
endfunction

%!test # a cantilever under the end moment 2 pi E I/l is a circle
%! scene = plane_rods ({"clamped", "free"}, [18 18]);
%! scene.rod.EA = 1e3;  # nothing stretches it
%! scene.tip_moment = @(t) 2*pi*t;
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! z = zeros (system.n, 1);
%! for t = 0.05:0.05:1
%!   z = equilibrium (surface_at_rest (scene, system), t, z);
%! endfor
%! xi = (0:0.1:1).';
%! f = system.fields (0, z, z, z, xi);
%! assert ([f.alpha1, f.alpha2], [sin(2*pi*xi), 1 - cos(2*pi*xi)]/(2*pi), 1e-8);

%!test # under 4 pi E I/l it lies on its circle twice
%! scene = rmfield (plane_rods ({"clamped", "free"}, [0 0]), "model");
%! scene.rod.EA = 1e6;
%! evalc ("rest = statics (setfield (scene, 'tip_moment', 4*pi), 'output', '');");
%! angle = 4*pi*linspace (0, 1, 41).';
%! assert (rest.shape{1}(:,1:2), [sin(angle), 1 - cos(angle)]/(4*pi), 1e-8);

%!function [along, across] = elastica (force)   # of a cantilever, Bisshopp and Drucker, Quart. Appl. Math. 3, 1945
%!  F = @(k, phi) quadgk (@(x) 1./sqrt (1 - k^2*sin (x).^2), phi, pi/2, "RelTol", 1e-13);
%!  E = @(k, phi) quadgk (@(x) sqrt (1 - k^2*sin (x).^2), phi, pi/2, "RelTol", 1e-13);
%!  start = @(k) asin (1/(k*sqrt (2)));
%!  k = fzero (@(k) F (k, start (k)) - sqrt (force), [0.708, 0.9999]);
%!  across = 1 - 2/sqrt (force)*E (k, start (k));
%!  along = sqrt (2*(2*k^2 - 1)/force);
%!endfunction

%!test # the elastica under an end force: elliptic integrals; and the values of Mattiasson, IJNME 17, 1981
%! [along, across] = elastica (10);
%! assert ([1 - along, across], [0.55500, 0.81061], 1e-5);
%! for force = [1 10]
%!   scene = plane_rods ({"clamped", "free"}, [16 16]);
%!   scene.force = @(t) [0 force*t 0];
%!   scene = check_surface_scene (scene);
%!   system = surface_rod (scene);
%!   z = zeros (system.n, 1);
%!   for t = 0.25:0.25:1
%!     z = equilibrium (surface_at_rest (scene, system), t, z);
%!   endfor
%!   f = system.fields (0, z, z, z, 1);
%!   [along, across] = elastica (force);
%!   assert ([f.alpha1, f.alpha2], [along, across], 3e-6);
%! endfor

%!function tip = chain (n, EI, rhoA, times)
%!  ## n rigid links of a total of 1 m, angles with the horizontal, springs at the joints
%!  [h, m] = deal (1/n, rhoA/n);
%!  [i, j] = ndgrid (1:n);
%!  beyond = n - max (i, j);
%!  inertia = m*h^2*(beyond + 1/2 - (i == j)/6);
%!  weight = m*9.81*h*(n - (1:n).' + 1/2);
%!  spring = EI/h*(diag (2*ones (n, 1)) - diag (ones (n-1, 1), 1) - diag (ones (n-1, 1), -1));
%!  spring(1) = spring(end) = EI/h;
%!  rate = @(t, y) link_rate (y, n, inertia, weight, spring);
%!  [~, y] = ode45 (rate, times, zeros (2*n, 1), odeset ("RelTol", 1e-6, "AbsTol", 1e-7));
%!  tip = h*[sum(cos (y(end,1:n))); sum(sin (y(end,1:n)))];
%!endfunction
%!function y_dot = link_rate (y, n, inertia, weight, spring)
%!  difference = y(1:n) - y(1:n).';
%!  torque = -(inertia.*sin (difference))*y(n+1:2*n).^2 - weight.*cos (y(1:n)) - spring*y(1:n);
%!  y_dot = [y(n+1:2*n); (inertia.*cos (difference)) \ torque];
%!endfunction

%!test # a soft pendulum from the horizontal against chains of rigid links, extrapolated
%! scene = setfield (large_swing (), "duration", 0.5);
%! scene.rod.EA = 2e5;
%! scene.model.modes = [12 12];
%! [coarse, fine] = deal (chain (10, 0.05, 0.1, [0 0.25 0.5]), chain (20, 0.05, 0.1, [0 0.25 0.5]));
%! expected = (4*fine - coarse)/3;
%! result = driver (setfield (scene, "frames_per_second", 20), "output", "");
%! assert (result.history.tip([1 3],end), expected, 0.1*norm (fine - coarse) + 1e-4);
%! assert (norm (fine - coarse) < 0.02);

%!function tip = under_dead_force (EA, strain)   # [shortening, deflection] of 2 m, 0.1 by 0.1 m, under 3 E I/l^2
%!  scene = plane_rods ({"clamped", "free"}, [16 16]);
%!  EI = 2.07e11*0.1^4/12;
%!  scene.rod = struct ("length", 2, "EA", EA, "EI", EI, "rhoA", 78);
%!  scene.force = [0, 3*EI/2^2, 0];
%!  scene.model.strain = strain;
%!  scene = check_surface_scene (scene);
%!  system = surface_rod (scene);
%!  z = equilibrium (surface_at_rest (scene, system), 0);
%!  f = system.fields (0, z, z, z, 2);
%!  tip = [2 - f.alpha1, f.alpha2];
%!endfunction
%!test # to 10 digits, inextensible and with its EA; Green's strain differs from the other by 1.5 strain^2
%! inextensible = 2*under_dead_force (4e12, "engineering") - under_dead_force (2e12, "engineering");
%! assert (inextensible, [0.5088403688 1.2065068830], 1e-9);
%! assert (under_dead_force (2.07e9, "engineering"), [0.5085373043 1.2072398545], 1e-9);
%! green = under_dead_force (2.07e9, "Green") - [0.5085373043 1.2072398545];
%! assert (norm (green) > 1e-8 && norm (green) < 1e-6);
