## -*- texinfo -*-
## @deftypefn {} {[@var{R}, @var{torque}] =} surface_support (@var{system}, @var{times}, @var{states})
## The force (3-by-m, N) of all that holds the rod of @code{surface_rod}, the surface and its ends together, at the
## @var{times} (1-by-m): what moves its mass, less its weight, the loads and the springs; and the @var{torque}
## (1-by-m, N m) of a hub that turns it.  It is the resultant of
## @code{normal_reaction} where the ends are free and bending asks for no couple about the rod, which the surface can
## only give by a force along itself.  It is as exact as the accelerations are (see @code{reaction_at_O}).
## @end deftypefn

function [R, torque] = surface_support (system, times, states)
  n = system.n;
  z_ddot = system.rate (times, states)(n+1:2*n,:);
  [z, z_dot] = deal (states(1:n,:), states(n+1:2*n,:));
  [~, ~, force] = loads_on_surface (system, times, z);
  R = -force - springs_on_surface (system, times, z, z_dot).force;
  turn = system.turn (times, z);
  for part = system.parts
    [density{1:3}] = system.surface.support (fields_of_basis (part.base, z, z_dot, z_ddot, turn), part.rod, ...
                                               system.gravity);
    R += cell2mat (cellfun (@(d) part.base.weights.'*d, density.', "uniformoutput", false));
  endfor
  [~, torque] = system.residual (times, z, z_dot, z_ddot);
  torque = torque(1,:);
endfunction

%!test # a hinged rod that turns steadily on the level plane, as stretched as that holds it: all three forces
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "ends", {{"hinge", "free"}}, "force", [40 0 -1], "model", struct ("modes", [5 5]), ...
%!                 "rod", struct ("length", 2, "EA", 1e6, "EI", 1e3, "rhoA", 3));
%! scene.initial.shape = @(xi) [xi + (3*25*(2^2*xi/2 - xi.^3/6) + 40*xi)/1e6; 0*xi];
%! scene.initial.velocity = @(xi, alpha) 5*[0*xi; alpha(1,:)];
%! scene = check_surface_scene (setfield (scene, "solver", "tolerance", 1e-12));  # it starts as stated
%! system = surface_rod (scene);
%! R = surface_support (system, [0 0.5], [system.initial_state, system.initial_state]);
%! assert (R, [-3*2^2/2*25 - 40; 0; 3*2*9.81 + 1]*[1 1], 0.1);
%!test # of a limp rod that slides in a bowl it is the resultant of the normal reaction
%! scene = setfield (setfield (bowl (), "duration", 0.1), "rod", "EI_normal", 0);
%! result = driver (setfield (scene, "rod", "EI", 1e-4), "output", "", "modes", [10 10], "tolerance", 1e-6);
%! [system, history] = deal (result.model, result.history);
%! z = system.place.basis.'*(history.q - system.place.start);
%! [n{1:3}] = system.surface.normal (system.fields (0, z, z, z, system.points));
%! resultant = cell2mat (cellfun (@(n) system.weights.'*(n.*history.reaction), n.', "uniformoutput", false));
%! assert (history.support, resultant, 1e-4*norm (resultant(:,1)));
%!test # and of one that is damped: stretched around a hollow it presses the more, the faster that is
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 0.5), "gravity", 0, "duration", 1, ...
%!                 "rod", struct ("length", 0.5, "EA", 30, "EI", 1, "EI_normal", 0, "rhoA", 1, "damping", 0.2));
%! scene.initial = struct ("angle", pi/2, "velocity", @(xi, alpha) [0*xi; xi - 0.25]);
%! scene.model.modes = [8 8];
%! scene.solver.tolerance = 1e-12;
%! system = surface_rod (check_surface_scene (scene));
%! n = system.n;
%! z = 0*system.initial_state(1:n);
%! y = [z; system.initial_state(n+1:end)];
%! r = normal_reaction (system, 0, z, y(n+1:2*n));
%! v = system.points - 0.25;
%! assert (r, -30*0.2/0.5 + v.^2/0.5, 1e-9);  # N curvature + rhoA v^2 curvature
