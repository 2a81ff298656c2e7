## -*- texinfo -*-
## @deftypefn {} {@var{motion} =} motion_of_rods (@var{Q}, @var{Q_dot})
## The coordinates (V; phi; x; y) of free rods and their rates (a column a rod or a time) as the generated functions
## take them: a struct of V, phi, x, y and V_dot, phi_dot, x_dot, y_dot.
## @end deftypefn

function motion = motion_of_rods (Q, Q_dot)
  n = rows (Q) - 3;
  motion.V = Q(1:n,:);
  motion.phi = Q(n+1,:);
  motion.x = Q(n+2,:);
  motion.y = Q(n+3,:);
  motion.V_dot = Q_dot(1:n,:);
  motion.phi_dot = Q_dot(n+1,:);
  motion.x_dot = Q_dot(n+2,:);
  motion.y_dot = Q_dot(n+3,:);
endfunction

%!test
%! motion = motion_of_rods ([1 2; 3 4; 5 6; 7 8], -[1 2; 3 4; 5 6; 7 8]);
%! assert (motion.V, [1 2]); assert (motion.phi, [3 4]); assert (motion.y_dot, -[7 8]);
