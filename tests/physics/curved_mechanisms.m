## -*- texinfo -*-
## @deftypefn {} {[@var{tip}, @var{alone}] =} curved_mechanisms (@var{count}, @var{level}, @var{tolerance}, @
##   @var{half_height})
## The semicircle of the scene arc_pendulum as so many equal arcs, bodies of a mechanism on a @var{level} of modes (see
## @code{mechanism_rungs}) with a longitudinal one for every two beyond the first, hung from one end and welded end to
## end: its @var{tip} (2-by-m, m) over 0.5 s, and that of the hinged rod @var{alone} with many base functions.  @var{half_height} (m) is the section's.
## @end deftypefn

function [tip, alone] = curved_mechanisms (count, level, tolerance, half_height = 0.003)
  whole = arc_pendulum ();
  whole.duration = 0.5;
  whole.rod.half_height = half_height;
  whole.frames_per_second = 20;
  whole.solver.tolerance = tolerance;
  whole.model.modes = [10 16];
  result = driver (whole, "output", "");
  alone = [result.history.tip_x; result.history.tip_y];

  scene = struct ("duration", 0.5, "frames_per_second", 20, "solver", struct ("tolerance", tolerance));
  rod = setfield (whole.rod, "length", whole.rod.length/count);
  chord = @(rod) build_curved_model (check_scene (setfield (whole, "rod", rod)), curved_rung ([0 1])).base.axis.tilt;
  tangent = whole.initial.phi + chord (whole.rod);
  for k = 1:count
    body = struct ("rod", rod, "model", struct ("energy", "uniaxial", "stiffening", "none"));
    body.initial.phi = tangent - chord (rod);
    scene.bodies{k} = body;
    scene.joints{k} = struct ("kind", "weld", "bodies", [k-1 k], "stations", [rod.length 0]);
    tangent += rod.curvature*rod.length;
  endfor
  scene.joints{1} = struct ("kind", "revolute", "bodies", 1, "stations", 0);
  scene = check_mechanism (scene);
  each = ones (1, count);
  mechanism = build_mechanism (scene, mechanism_rungs (scene, level*each, floor ((level - 1)/2)*each));
  last = run_model (mechanism_kind (), scene, mechanism).history.bodies(count);
  tip = [last.tip_x; last.tip_y];
endfunction

%!function off = distance_of (varargin)
%!  [tip, alone] = curved_mechanisms (varargin{:});
%!  off = max (hypot ((tip - alone)(1,:), (tip - alone)(2,:)));
%!endfunction
%!test # one body on a revolute joint tends to the hinged rod
%! off = [distance_of(1, 3, 1e-7), distance_of(1, 8, 1e-7)];
%! assert (off(1) < 1e-3); assert (off(2) < off(1)/20);
%!test # two stiff quarter circles, welded, tend to the semicircle; soft ones turn apart as the deformation squared
%! off = [distance_of(2, 2, 1e-7, 0.024), distance_of(2, 6, 1e-7, 0.024)];
%! assert (off(2) < 3e-6); assert (off(2) < off(1)/2);
%! assert (distance_of (2, 6, 1e-7, 0.012) < distance_of (2, 6, 1e-7, 0.006)/10);
