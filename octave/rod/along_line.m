## -*- texinfo -*-
## @deftypefn {} {@var{at} =} along_line (@var{line}, @var{motion})
## The fields of a geometrically exact rod at the p points of its @var{line} (see @code{line_points}) in k motions (a
## struct of V, phi and their rates): a struct of stretch, angle and their rates, and of how the centreline goes on
## there, its rates and derivatives (see @code{rod_exact_line}; p-by-k): x, y, x_dot, y_dot, x_convection, y_convection,
## by_stretch_x, by_stretch_y, by_angle_x, by_angle_y.
## @end deftypefn

function at = along_line (line, motion)
  at.stretch = line.stretch*motion.V;
  at.angle = line.angle + motion.phi + line.turn*motion.V;
  at.stretch_dot = line.stretch*motion.V_dot;
  at.angle_dot = motion.phi_dot + line.turn*motion.V_dot;
  [at.x, at.y, at.x_dot, at.y_dot, at.x_convection, at.y_convection, at.by_stretch_x, at.by_stretch_y, ...
   at.by_angle_x, at.by_angle_y] = rod_exact_line (at);
endfunction

%!test # a straight rod of one polynomial each, turned and stretched: 1 + e along its angle
%! line = struct ("stretch", [0.5; 0.5], "turn", [0; 0], "angle", [0; 0]);
%! at = along_line (line, struct ("V", [0.2 0.4], "V_dot", [1 0], "phi", [0 pi/2], "phi_dot", [0 3]));
%! assert ([at.x; at.y], [1.1 0; 1.1 0; 0 1.2; 0 1.2], 1e-15);
%! assert ([at.x_dot; at.y_dot], [0.5 -3.6; 0.5 -3.6; 0 0; 0 0], 1e-14);
%! assert (at.y_convection, -9*1.2*[0 1; 0 1], 1e-14);
