## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} curved_surfaces (@var{surface}, @var{rod}, @var{duration})
## A free rod on a @var{surface} for the tests of this file.
## @end deftypefn

function scene = curved_surfaces (surface, rod, duration)
  scene = struct ("surface", surface, "rod", rod, "duration", duration, "frames_per_second", 20);
  scene.model.modes = [10 10];
endfunction

%!test # every surface: power of all forces is the rate of the energies, and what damping takes, by differences, at random states
%! rand ("seed", 2);
%! parameters = {"plane", {"inclination"}; "cylinder", {"radius"}; "cone", {"half_angle"}; "sphere", {"radius"}; ...
%!               "torus", {"core_radius", "tube_radius"}; "saddle", {"rise", "fall"}; ...
%!               "bumps", {"height", "wave_number_1", "wave_number_2"}};
%! for entry = parameters.'
%!   surface.name = entry{1};
%!   for name = entry{2}
%!     surface.(name{1}) = 0.4 + 0.3*rand ();
%!   endfor
%!   rod = struct ("length", 0.5, "EA", 10, "EI", 1, "EI_normal", 2, "GJ", 3, "rhoA", 1, ...
%!                 "damping", 0.1, "curvature", 0.3);
%!   scene = curved_surfaces (surface, rod, 1);
%!   scene.model.modes = [4 5];
%!   scene.initial = struct ("point", [0.6 0.5], "angle", rand ());
%!   system = surface_rod (check_surface_scene (scene));
%!   [z, z_dot, z_ddot] = deal (0.02*rand (system.n, 1), rand (system.n, 1), rand (system.n, 1));
%!   h = 1e-4;
%!   E = @(s) sum (surface_energies (system, 0, z + s*z_dot + s^2/2*z_ddot, z_dot + s*z_ddot)(1:3,:), 1);
%!   rate = (8*(E (h) - E (-h)) - (E (2*h) - E (-2*h)))/(12*h);
%!   assert (z_dot.'*system.residual (0, z, z_dot, z_ddot) - system.power (0, z, z_dot, z_ddot)(2), rate, ...
%!           1e-6*abs (rate) + 1e-8);
%!   clear surface;
%! endfor

%!test # a cylinder is developable: without gravity and bending across it, the motion is that on the plane
%! results = {};
%! rod = struct ("length", 0.8, "EA", 200, "EI", 0.1, "EI_normal", 0, "rhoA", 0.5);
%! for surface = {struct("name", "plane", "inclination", 0), struct("name", "cylinder", "radius", 0.2)}
%!   scene = curved_surfaces (surface{1}, rod, 0.1);
%!   scene.gravity = 0;
%!   scene.initial = struct ("angle", 0.6, "velocity", @(xi, alpha) [cos(3*xi); sin(5*xi)]);
%!   results{end+1} = driver (setfield (scene, "model", "modes", [6 6]), "output", "").history.q;
%! endfor
%! assert (results{1}, results{2}, 1e-7);
%! assert (norm (results{1}(:,end) - results{1}(:,1)) > 0.05);

%!test # a rod rests straight along the lowest ruling
%! rod = struct ("length", 1, "EA", 1e3, "EI", 1, "rhoA", 1);
%! scene = curved_surfaces (struct ("name", "cylinder", "radius", 0.3), rod, 1);
%! system = surface_rod (check_surface_scene (scene));
%! z = zeros (system.n, 1);
%! assert (system.residual (0, z, z, z), z, 1e-8);

%!function alpha_dot = turning (alpha, omega, R)   # rotation of the sphere in its stereographic chart
%!  square = sum (alpha.^2, 1)/(4*R^2);
%!  r = [alpha; R*(square - 1)]./(1 + square);
%!  v = cross (repmat (omega, 1, columns (r)), r);
%!  alpha_dot = 2*R*(v(1:2,:)./(R - r(3,:)) + r(1:2,:).*v(3,:)./(R - r(3,:)).^2);
%!endfunction

%!test # a short stiff rod tends to the spherical pendulum, with the square of its length
%! R = 0.5;
%! velocity = turning ([0.2; 0.1], [0; 0; 3], R);
%! scene = curved_surfaces (struct ("name", "sphere", "radius", R), [], 0.4);
%! scene.initial.velocity = @(xi, alpha) turning (alpha, [0; 0; 3], R);
%! r = [0.2; 0.1; R*(0.05/(4*R^2) - 1)]/(1 + 0.05/(4*R^2));
%! rate = @(t, y) [y(4:6); [0; 0; -9.81] - y(1:3)*(sumsq (y(4:6)) - 9.81*y(3))/R^2];
%! [~, y] = ode45 (rate, [0 0.2 0.4], [r; cross([0; 0; 3], r)], odeset ("RelTol", 1e-10, "AbsTol", 1e-10));
%! for k = 1:2
%!   l = 0.4/2^k;
%!   scene.rod = struct ("length", l, "EA", 50, "EI", 1e-2, "EI_normal", 0, "rhoA", 1);
%!   scene.initial.shape = @(xi) [0.2 + (xi - l/2)*1.05; 0.1 + 0*xi];
%!   scene.model.modes = [3 3];
%!   history = driver (scene, "output", "").history;
%!   off(k) = norm ([history.x(51,end); history.y(51,end); history.z(51,end)] - y(end,1:3).');
%! endfor
%! assert (off(2) < 1e-3);
%! assert (off(2) < off(1)/3.5);

%!function result = flung (speed)   # a rod on a great circle about the axis, and how far it leaves that circle
%!  R = 0.5;
%!  rod = struct ("length", 0.4, "EA", 50, "EI", 0.1, "EI_normal", 0, "rhoA", 1);
%!  scene = curved_surfaces (struct ("name", "sphere", "radius", R), rod, 0.2);
%!  scene.gravity = 0;
%!  scene.solver.tolerance = 1e-6;
%!  scene.initial = struct ("point", [0.2 -0.1], "angle", 1.2);
%!  surface = surface_functions (scene.surface);
%!  ends = laid_rod (surface, struct ("curvature", []), [0.2 -0.1], 1.2, [0 0.4]);
%!  [x, y, z] = surface.position (struct ("alpha1", ends(1,:), "alpha2", ends(2,:)));
%!  axis = cross ([x(1); y(1); z(1)], [x(2); y(2); z(2)]);
%!  axis /= norm (axis);
%!  scene.initial.velocity = @(xi, alpha) speed (xi).*turning (alpha, 2*axis, R) ...
%!                                        + turning (alpha, (speed (0) == 1)*[1; 0.5; -1], R);
%!  result = driver (scene, "output", "");
%!  h = result.history;
%!  result.off = max (vec (abs (axis(1)*h.x + axis(2)*h.y + axis(3)*h.z)));
%!  result.kept = max (result.summary.angular_momentum_change)/norm (h.angular_momentum(:,1));
%!endfunction

%!test # without gravity a free rod on a great circle, stretched as it runs along it, stays on it
%! assert (flung (@(xi) 1 + 0.2*cos (pi*xi/0.4)).off < 1e-7);
%!test # angular momentum about every axis stays to 1e-8
%! result = flung (@(xi) 1 + 0*xi);
%! assert (result.off > 0.01);
%! assert (result.kept < 1e-8);

%!test # with gravity angular momentum about the vertical stays to 1e-8
%! scene = setfield (setfield (bowl (), "duration", 0.05), "solver", "tolerance", 1e-7);
%! result = driver (setfield (scene, "model", "modes", [8 8]), "output", "");
%! assert (result.summary.angular_momentum_change(3) < 1e-8*abs (result.history.angular_momentum(3,1)));
%! assert (result.summary.largest_energy_error < 1e-7);

%!test # the other scenes' energy, and no pull on a rod inside of a cylinder
%! for name = {"cylinder", "saddle"}
%!   result = driver (setfield (setfield (feval (name{1}), "duration", 0.1), "model", "modes", [8 8]), "output", "");
%!   assert (result.summary.largest_energy_error < 1e-7);
%!   assert (result.summary.warnings, {});
%! endfor

%!error <the rod meets a point at the start where the surface's chart is singular>   # across the tip of a cone
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! scene = curved_surfaces (struct ("name", "cone", "half_angle", 0.7), rod, 1);
%! scene.initial.shape = @(xi) [xi - 0.4; 0.3 + 0*xi];
%! driver (scene, "output", "");

%!test # sines beside four polynomials tend to the motion that polynomials alone tend to
%! short = setfield (setfield (bowl (), "duration", 0.1), "solver", "tolerance", 1e-5);
%! with = @(modes, sines) setfield (setfield (short, "model", "modes", modes), "model", "sines", sines);
%! motion = @(varargin) driver (with (varargin{:}), "output", "").history;
%! rich = motion ([10 10], [0 0]);
%! off = @(h) max (sqrt ((h.x - rich.x).^2 + (h.y - rich.y).^2 + (h.z - rich.z).^2)(:));
%! [none, few, more] = deal (off (motion ([4 4], [0 0])), off (motion ([4 4], [2 2])), off (motion ([4 4], [5 5])));
%! assert (few < none/20);
%! assert (more < few/3);
