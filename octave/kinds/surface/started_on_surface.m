## -*- texinfo -*-
## @deftypefn {} {@var{system} =} started_on_surface (@var{system}, @var{scene})
## The @var{system} of a rod on a surface (see @code{surface_rod}) of a checked @var{scene} with what belongs to its
## start: initial_state, in equilibrium or as it is placed, what is fast and small at rest (see
## @code{quasi_stationary}); mass and stiffness, linear about it; size and state_scale, which tell how far a change of
## coordinates moves points of the rod.
## @end deftypefn

function system = started_on_surface (system, scene)
  start = zeros (system.n, 1);
  velocity = system.place.basis.'*system.place.velocity;
  inside = system.parts(1).base;
  scale = lengths_per_coordinate (system.surface, fields_of_basis (inside, start, velocity, start));
  system.size = @(z) max (max (abs (inside.values{1}*z)*scale(1), abs (inside.values{2}*z)*scale(2))(:));
  if (strcmp (scene.initial.from, "equilibrium"))
    start = equilibrium (surface_at_rest (scene, system), 0);
    velocity = 0*start;
  else
    start = quasi_stationary (system, start, velocity, scene.solver.tolerance/20);
  endif
  system.mass = system.mass_matrix (start);
  system.stiffness = system.tangent_stiffness (0, start, velocity, start);
  per_coordinate = 1./max (max (abs (inside.values{1}))*scale(1), max (abs (inside.values{2}))*scale(2)).';
  system.initial_state = [start; velocity; 0; 0];
  r = scene.rod;
  joules = (rod_mass (r.length, r.rhoA) + scene.tip_mass)*abs (scene.gravity) + r.EI/r.length^2;
  system.state_scale = [per_coordinate; per_coordinate/scene.duration; joules; joules];
endfunction

function scale = lengths_per_coordinate (surface, fields)
  [a_11, ~, a_22] = surface.mass (fields, struct ("rhoA", 1));
  scale = sqrt ([max(a_11(:)), max(a_22(:))]);
endfunction

%!function scene = swinging ()
%!  scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 1, ...
%!                  "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "rhoA", 2), "tip_mass", 0.7, ...
%!                  "model", struct ("modes", [4 5]));
%!  scene = check_surface_scene (scene);
%!endfunction
%!test # the work may be off by what weight and bending do over so many metres
%! system = surface_rod (swinging ());
%! assert (system.state_scale(end-1:end), (2*1*9.81 + 0.7*9.81 + 0.1/1^2)*[1; 1], 1e-12);
%! scene = setfield (setfield (swinging (), "tip_mass", 0), "force_station", 0.5);
%! scene.joints = scene.joints([]);
%! short = surface_rod (setfield (scene, "rod", "length", 0.5));
%! assert (short.state_scale(end), 2*0.5*9.81 + 0.1/0.5^2, 1e-12);
%!test # and each coordinate by what moves no point by more than a metre, but one
%! system = surface_rod (swinging ());
%! moved = @(k) system.size (system.state_scale(k)*((1:system.n).' == k));
%! assert (arrayfun (moved, 1:system.n), ones (1, system.n), 1e-12);
%! assert (system.state_scale(system.n + (1:system.n)), system.state_scale(1:system.n)/1, 1e-12);
%!test # its stiffness is that under the loads at the start
%! scene = struct ("surface", struct ("name", "sphere", "radius", 1), "duration", 1, "force", @(t) [0 0 50*t], ...
%!                 "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "rhoA", 2), "model", struct ("modes", [4 4]));
%! system = surface_rod (check_surface_scene (scene));
%! z = system.initial_state(1:system.n);
%! assert (system.stiffness, system.tangent_stiffness (0, z, 0*z, z), 1e-12);
%! assert (norm (system.stiffness - system.tangent_stiffness (1, z, 0*z, z)) > 1);
