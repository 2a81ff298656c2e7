## -*- texinfo -*-
## @deftypefn {} {[@var{force_q}, @var{force_phi}, @var{w4}] =} dropped_forces (@var{points}, @var{motion}, @
##   @var{loads})
## Generalized forces of what a rod's model drops (see maxima/rod/dropped.mac), on its coordinates q (n-by-m) and
## its rotation (1-by-m) at m times, and by how much its @var{points} (see @code{dropped_points}) come nearer to O than
## the model has them (p-by-m, m).
##
## @var{motion} has q, q_dot, q_ddot (n-by-m), phi, phi_dot, phi_ddot, x_ddot, y_ddot (1-by-m: of the frame's origin)
## and followers (N1-by-m: amplitudes of longitudinal modes without inertia, or empty); @var{loads} has gravity, moment
## (at O), force_x and force_y (1-by-m).
## @end deftypefn

function [force_q, force_phi, w4] = dropped_forces (points, motion, loads)
  q = motion.q;
  q_dot = motion.q_dot;
  q_ddot = motion.q_ddot;
  along = points.along;
  across = points.across;
  follow = @(k) 0;
  if (! isempty (motion.followers))
    follow = @(k) points.of_followers{k}*motion.followers;
  endif
  field = struct ("v1", along{1}*q + follow (1), "v1_dot", along{1}*q_dot, "v1_ddot", along{1}*q_ddot, ...
                  "v2", across{1}*q, "v2_dot", across{1}*q_dot, "v2_ddot", across{1}*q_ddot, ...
                  "stretch", along{2}*q + follow (2), "stretch_dot", along{2}*q_dot, ...
                  "stretch_ddot", along{2}*q_ddot, ...
                  "slope", across{2}*q, "slope_dot", across{2}*q_dot, "slope_ddot", across{2}*q_ddot, ...
                  "stretch_slope", along{3}*q + follow (3), "bend", across{3}*q);
  [w2, w4, w2_dot, w4_dot, w2_ddot] = rod_shortening_rates (field);
  m = columns (q);
  all = points.integral*[w2, w4, w2_dot, w4_dot, w2_ddot];
  part = @(k) all(:,(k-1)*m+(1:m));
  w4 = part (2);
  field.w2 = part (1);
  field.w4 = w4;
  field.w2_dot = part (3);
  field.w4_dot = part (4);
  field.w2_ddot = part (5);

  [on_v1, on_v2, on_w2, on_w4, on_stretch, on_stretch_slope, on_slope, on_bend, on_phi] = rod_dropped_forces (
    motion, field, points, loads.gravity, loads);
  [on_slope, on_stretch] = rod_pull_on_slopes (field.slope, field.stretch, on_slope, on_stretch, ...
                                               points.integral.'*on_w2, points.integral.'*on_w4);
  force_q = across{1}.'*on_v2 + across{2}.'*on_slope + across{3}.'*on_bend + ...
            along{1}.'*on_v1 + along{2}.'*on_stretch + along{3}.'*on_stretch_slope;
  force_phi = sum (on_phi, 1);

  at_O = {points.slope_at_O*q, points.slope_at_O*q_dot, points.stretch_at_O*q, points.stretch_at_O*q_dot};
  [~, ~, by_slope, by_stretch] = rod_dropped_angle (at_O{:});
  force_q += points.slope_at_O.'*(loads.moment.*by_slope) + points.stretch_at_O.'*(loads.moment.*by_stretch);
endfunction

%!function [points, motion, loads] = at_rest (amplitude)   # a half wave that stands
%!  [scene, model] = sample_rod ([0 1], "rod.half_height", 0.01, "model.stiffening", "foreshortening");
%!  points = dropped_points (model, scene);
%!  motion = struct ("q", amplitude, "q_dot", 0, "q_ddot", 0, "phi", 0.3, "phi_dot", 0, "phi_ddot", 0, ...
%!                   "x_ddot", 0, "y_ddot", 0, "followers", []);
%!  loads = struct ("gravity", 0, "moment", 0, "force_x", 0, "force_y", 0);
%!endfunction
%!test # the exact curvature's energy: EI/2 times the integral of v2,11^2/(1 - v2,1^2), by differences
%! [points, motion, loads] = at_rest (0.05);
%! EI = sum (points.EI); k = pi;
%! energy = @(a) EI/2*quadgk (@(x) (a*k^2*sin (k*x)).^2.*(1./(1 - (a*k*cos (k*x)).^2) - 1), 0, 1);
%! expected = -(energy (0.0501) - energy (0.0499))/2e-4;
%! assert (dropped_forces (points, motion, loads), expected, 0.04*abs (expected));
%!test # weight: the work that it does as the tip comes nearer
%! [points, motion, loads] = at_rest (0.05);
%! [none, ~, w4] = dropped_forces (points, motion, loads);
%! [with, torque] = dropped_forces (points, motion, setfield (loads, "gravity", 9.81));
%! nearer = @(a) quadgk (@(x) (1 - x).*(1 - sqrt (1 - (a*pi*cos (pi*x)).^2) - (a*pi*cos (pi*x)).^2/2), 0, 1);
%! rhoA = sum (points.rhoA);
%! expected = 9.81*sin (0.3)*rhoA*(nearer (0.0501) - nearer (0.0499))/2e-4;
%! assert (with - none, expected, 0.02*expected);
%! assert (torque, 9.81*cos (0.3)*rhoA*nearer (0.05), 0.02*9.81*rhoA*nearer (0.05));
%! assert (w4(end), quadgk (@(x) (0.05*pi*cos (pi*x)).^4/8, 0, 1), 1e-12);
%!test # a moment at O works on the angle that the slope really has
%! [points, motion, loads] = at_rest (0.05);
%! with = dropped_forces (points, motion, setfield (loads, "moment", 7)) - dropped_forces (points, motion, loads);
%! angle = @(a) asin (a*pi) - atan (a*pi);
%! assert (with, 7*(angle (0.0501) - angle (0.0499))/2e-4, 0.02*with);
%!test # stretching that follows is stretching
%! [scene, model] = sample_rod ([1 1], "rod.half_height", 0.01, "model.stiffening", "foreshortening");
%! points = dropped_points (model, scene);
%! [~, motion, loads] = at_rest (0);
%! none = [0; 0];
%! motion = setfield (setfield (motion, "q_dot", none), "q_ddot", none);
%! [motion.phi_dot, motion.phi_ddot, loads.gravity] = deal (20, 30, 9.81);
%! [expected{1:2}] = dropped_forces (points, setfield (motion, "q", [0.01; 0.05]), loads);
%! points.of_followers = cellfun (@(along) along(:,1), points.along, "uniformoutput", false);
%! motion = setfield (setfield (motion, "q", [0; 0.05]), "followers", 0.01);
%! [found{1:2}] = dropped_forces (points, motion, loads);
%! assert (found, expected, 1e-9*norm (expected{1}));
