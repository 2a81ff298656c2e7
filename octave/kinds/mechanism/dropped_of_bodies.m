## -*- texinfo -*-
## @deftypefn {} {@var{dropped} =} dropped_of_bodies (@var{scene}, @var{mechanism}, @var{history})
## How far what the rods' models drop beyond foreshortening may move a mechanism's points, without what it does over
## time, a struct as from @code{dropped_error} of which only the bound is known: the straight bodies' sum of how much
## nearer their points come to O, and how much their modes give to the forces of what is dropped (see
## @code{dropped_forces}; with weight and rotation, without accelerations).
## @end deftypefn

function dropped = dropped_of_bodies (scene, mechanism, history)
  metres = 0;
  for k = 1:numel (history.bodies)
    model = mechanism.models{k};
    if (isempty (scene.bodies(k).rod.curvature) && model.rung.bending > 0)
      metres += of_body (model, history.bodies(k), scene.bodies(k).tip_mass, scene.gravity);
    endif
  endfor
  dropped = struct ("metres", metres, "x", 0, "y", 0, "bound", metres);
endfunction

function metres = of_body (model, body, tip_mass, gravity)
  none = 0*body.phi;
  points = dropped_points (model, struct ("tip_mass", tip_mass, "force_station", 0));
  motion = struct ("q", body.V, "q_dot", 0*body.V, "q_ddot", 0*body.V, "phi", body.phi, "phi_dot", body.phi_dot, ...
                   "phi_ddot", none, "x_ddot", none, "y_ddot", none, "followers", []);
  loads = struct ("gravity", gravity, "moment", none, "force_x", none, "force_y", none);
  force = dropped_forces (points, motion, loads);
  stations = linspace (0, model.length, 21);
  [along, across] = functions_at (model.base, stations);
  given = model.arrays.stiffness_matrix \ force;
  nearer = dropped_shortening (model, stations, body.V);
  metres = max (hypot (along*given - nearer, across*given)(:));
endfunction

%!test # a half wave a sin (pi xi/l): its stiffness grows by (a pi/l)^2/2 of itself
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1e9, "EI", 20, "rhoA", 1), ...
%!                        "model", struct ("modes", [0 1], "stiffening", "foreshortening"))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! scene.duration = 1; scene.gravity = 0;
%! scene = check_mechanism (scene);
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, 0));
%! history.bodies = struct ("V", [0.01 0.02], "phi", [0 0], "phi_dot", [0 0]);
%! assert (dropped_of_bodies (scene, mechanism, history).bound, 0.02*(0.02*pi/2)^2/2, 0.01*0.02*(0.02*pi/2)^2/2);
