## -*- texinfo -*-
## @deftypefn {} {@var{modal} =} modal_form (@var{system}, @var{stiffness})
## A system (see @code{hinged_rod}) in the modal coordinates of its mass and a @var{stiffness} matrix: x = X*eta,
## where eta_ddot = -omega^2 eta + what is left.  A state of the form is z = (eta; eta_dot; w), w what follows
## the rates in y.
##
## Fields: omega, damping (n-by-1, 1/s: of system.damping_matrix, if there is one), n, X (n-by-n), state (z) = y,
## form (y) = z, and remainder (t, z), the rate of z without the free oscillation (eta_dot; -omega^2 eta - damping
## eta_dot; 0), which is the stiff part of the system.  A direction that the stiffness does not hold has omega = 0.
## @end deftypefn

function modal = modal_form (system, stiffness)
  n = rows (system.mass);
  [X, squares] = free_modes (stiffness, system.mass);
  squares = max (squares, 0);
  damping = zeros (n, 1);
  if (isfield (system, "damping_matrix"))
    damping = reshape (diag (X \ (system.mass \ (system.damping_matrix*X))), n, 1);  # of a rigid rod: 0-by-1
  endif
  modal = struct ("n", n, "omega", sqrt (squares), "damping", damping, "X", X);
  position = 1:n;
  velocity = n+1:2*n;
  state = eye (numel (system.initial_state));
  stiff = 0*state;
  state(position,position) = X;
  state(velocity,velocity) = system.velocity_matrix*X;
  stiff(position,velocity) = eye (n);
  stiff(velocity,[position, velocity]) = -[diag(squares), diag(damping)];
  form = sparse (inv (state).');
  state = sparse (state.');
  stiff = sparse (stiff.');
  ## full times sparse: in this order it is fast
  modal.state = @(z) (z.'*state).';
  modal.form = @(y) (y.'*form).';
  modal.remainder = @(t, z) (system.rate (t, (z.'*state).').'*form - z.'*stiff).';
endfunction

%!test # of a linear system nothing is left
%! system = struct ("mass", [2 1; 1 3], "stiffness", [5 0; 0 0], "velocity_matrix", [1 0; 1 3], ...
%!                  "initial_state", zeros (5, 1));
%! system.rate = @(t, y) [[1 0; 1 3]\y(3:4); -[1 0; 1 3]*([2 1; 1 3]\([5 0; 0 0]*y(1:2))); 1];
%! modal = modal_form (system, system.stiffness);
%! y = [0.1; 0.2; 0.3; 0.4; 0.5];
%! assert (modal.state (modal.form (y)), y, 1e-14);
%! assert (modal.remainder (0, modal.form (y)), [0; 0; 0; 0; 1], 1e-14);
%! assert (modal.omega(1), 0, 1e-7);
%!test # a rigid rod in a hub has no modes, whatever its material dissipates
%! system = struct ("mass", [], "damping_matrix", [], "velocity_matrix", [], "initial_state", [0; 0]);
%! system.rate = @(t, y) [1; 0];
%! modal = modal_form (system, []);
%! assert (modal.omega, zeros (0, 1)); assert (modal.damping, zeros (0, 1));
%! assert (modal.remainder (0, [5; 6]), [1; 0]);
