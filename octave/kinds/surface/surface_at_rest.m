## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} surface_at_rest (@var{scene}, @var{system}, @var{still})
## The balance of forces of the rod of a checked scene on its surface, whose @var{system} is of @code{surface_rod};
## fields as in @code{mechanism_at_rest}, of one body without multipliers, whose shape has x, y and z; and
## interpolation (82-by-n): what the surface's coordinates are off at 41 places.  A hub stands still at rest, unless
## @var{still} (default: the system, stopped) is the system itself.
## @end deftypefn

function balance = surface_at_rest (scene, system, still = system.stopped ())
  scene.model.modes = system.numbers.modes;
  balance.n = system.n;
  balance.multipliers = 0;
  balance.start = zeros (system.n, 1);
  balance.residual = @(t, z, v, lambda) -still.residual (t.*ones (1, columns (z)), z, v, 0*z);
  balance.tangent = @(t, z, lambda) still.tangent_stiffness (t, z, 0*z, 0*z);
  balance.damping = @(t, z, lambda) still.tangent_damping (t, z, 0*z, 0*z);
  balance.mass = @(z) system.mass_matrix (z);
  balance.accelerations = @(t, z, v) accelerations (system, t, z, v);
  balance.moving = @(t, z, v, a, lambda) -system.residual (t.*ones (1, columns (z)), z, v, a);
  balance.jacobian = @(z) zeros (0, system.n);
  balance.size = system.size;
  balance.length = scene.rod.length;
  stations = linspace (0, scene.rod.length, 41).';
  balance.shape = @(z) {shape(system, system.fields (0, z, 0*z, 0*z, stations))};
  b = surface_basis (scene, system.place, stations);
  balance.interpolation = [b.values{1}; b.values{2}];
  balance.supports = @(t, z, lambda) supports (still, t, z);
  balance.along = @(t, z, lambda) {surface_section(system, z, stations)};
  balance.most = 32;
  balance.bodies = {1:system.n};
  balance.names = {"rod"};
endfunction

function [a, lambda] = accelerations (system, t, z, v)
  a = system.rate (t, [z; v; 0; 0])(system.n+1:2*system.n);
  lambda = zeros (0, 1);
endfunction

function rows = supports (system, t, z)
  R = surface_support (system, t, [z; 0*z; 0; 0]);
  rows = {"reaction_x [N]", R(1); "reaction_y [N]", R(2); "reaction_z [N]", R(3)};
endfunction

function places = shape (system, fields)
  [x, y, z] = system.surface.position (fields);
  places = permute (cat (3, x, y, z), [1 3 2]);
endfunction

%!test # at rest on a level plane nothing is out of balance; the middle of three polynomials stretches it
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [3 3]));
%! scene = check_surface_scene (scene);
%! balance = surface_at_rest (scene, surface_rod (scene));
%! z = balance.start;
%! assert (balance.residual (0, z, z, []), zeros (6, 1), 1e-12);
%! assert (balance.residual (0, 1e-5*(1:6 == 2).', z, [])(2), -3*2*1e-5, 1e-8);
%! assert (balance.shape (z){1}([1 end],:), [0 0 0; 2 0 0], 1e-12);
%! assert (balance.shape ([z, 0.05*(1:6 == 2).']){1}([1 end],1,2), [-0.05; 2.05], 1e-12);
%! assert (balance.names, {"rod"}); assert (balance.bodies, {1:6});
%! z = 0.01*(1:6 == 2).';
%! a = balance.accelerations (0, z, 0*z);  # with these nothing is out of balance
%! assert (balance.moving (0, z, 0*z, a, []), zeros (6, 1), 1e-12); assert (norm (a) > 0.01);
%!test # in a hub that turns it is at rest as if that stood still where it is, and moves as it does
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, "force", [0 -0.1 0], ...
%!                 "ends", {{"clamped", "free"}}, "rotation", @(t) [5*t, 5, 0], "model", struct ("modes", [6 6]), ...
%!                 "rod", struct ("length", 1, "EA", 1e3, "EI", 1, "rhoA", 1));
%! at_rest = @(scene) surface_at_rest (check_surface_scene (scene), surface_rod (check_surface_scene (scene)));
%! balance = at_rest (scene);
%! still = at_rest (rmfield (scene, "rotation"));
%! z = equilibrium (still, 0);
%! assert (balance.residual (0, z, 0*z, []), zeros (rows (z), 1), 1e-9);
%! assert (balance.tangent (0, z, []), still.tangent (0, z, []), 1e-9);
%! assert (cell2mat (balance.supports (0, z, [])(:,2)), [0; 0.1; 9.81], 1e-9);
%! assert (balance.moving (0, z, 0*z, 0*z, [])(1) > 1);  # it is flung out
