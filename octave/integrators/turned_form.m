## -*- texinfo -*-
## @deftypefn {} {@var{turned} =} turned_form (@var{system}, @var{start}, @var{y})
## A system for explicit methods without the stiffness of its linear modes, for a while from the time @var{start} (s)
## and the state @var{y} on: by variation of constants.  The modal coordinates (see @code{modal_form}, with the
## stiffness of the rod as it turns) are those that the constants u would have become, left to oscillate under the
## remainder at the start, as if it stayed; only its change moves u.
##
## Fields: rate (t, u), state (t, u) = y, start = u at the start, and scale, what u may be off by where a centreline
## point is off by 1 m.
## @end deftypefn

function turned = turned_form (system, start, y)
  if (isfield (system, "damping_matrix"))
    system = rmfield (system, "damping_matrix");  # it cannot be turned back
  endif
  modal = modal_form (system, system.stiffness_at (start, y));
  n = modal.n;
  turned.start = modal.form (y);
  constant = modal.remainder (start, turned.start);
  flow = @(tau) exponential_step (modal.omega, modal.damping, tau, numel (y) - 2*n).whole;
  swap = [n+1:2*n, 1:n, 2*n+1:numel(y)];
  turned.state = @(t, u) modal.state (led (flow (t - start), u, constant, swap));
  turned.rate = @(t, u) turned_rate (t, u, start, modal.omega, n, modal.remainder, constant);
  coordinates = min (system.state_scale(1:n)./abs (modal.X), [], 1).';
  turned.scale = [coordinates; coordinates.*max(modal.omega, 1/system.duration); system.state_scale(2*n+1:end)];
endfunction

function z = led (flow, u, constant, swap)
  z = flow.free(:,1).*u + flow.free(:,2).*u(swap) + flow.phi1(:,1).*constant + flow.phi1(:,2).*constant(swap);
endfunction

function u_dot = turned_rate (t, u, start, omega, n, remainder, constant)
  tau = t - start;
  squares = omega.^2;
  cosine = cos (omega*tau);
  sine = sin (omega*tau)./omega;
  versine = (1 - cosine)./squares;
  still = omega == 0;
  sine(still) = tau;
  versine(still) = tau^2/2;
  eta = u(1:n);
  eta_dot = u(n+1:2*n);
  force = constant(1:n);
  force_dot = constant(n+1:2*n);
  r = remainder (t, [cosine.*eta + sine.*eta_dot + sine.*force + versine.*force_dot
                     cosine.*eta_dot - squares.*sine.*eta + sine.*force_dot - squares.*versine.*force
                     u(2*n+1:end) + tau*constant(2*n+1:end)]) - constant;
  eta = r(1:n);
  eta_dot = r(n+1:2*n);
  u_dot = [cosine.*eta - sine.*eta_dot; cosine.*eta_dot + squares.*sine.*eta; r(2*n+1:end)];
endfunction

%!test # what oscillates under a constant load stands still, the state comes back
%! system = struct ("mass", eye (2), "stiffness_at", @(t, y) diag ([0 9]), "state_scale", ones (5, 1), ...
%!                  "duration", 1, "velocity_matrix", eye (2), "initial_state", zeros (5, 1));
%! system.rate = @(t, y) [y(3:4); [2; 18] - [0; 9].*y(1:2); y(3)];
%! turned = turned_form (system, 2, [1; 2; 3; 4; 5]);
%! assert (turned.rate (2.7, turned.start)(1:4), zeros (4, 1), 1e-14);
%! tau = pi/3;
%! assert (turned.state (2 + tau, turned.start)(1:4), [1 + 3*tau + tau^2; 2; 3 + 2*tau; -4], 1e-13);
%!test # what u moves is the system's own motion: of two coupled oscillators, one of them free, and a third row
%! system = struct ("mass", [2 0.3; 0.3 1], "stiffness_at", @(t, y) [9 -9; -9 9], "state_scale", ones (5, 1), ...
%!                  "duration", 1, "velocity_matrix", eye (2), "initial_state", zeros (5, 1));
%! system.rate = @(t, y) [y(3:4); sin(t) - y(1)^2 - 8*y(2); cos(y(1)) - 3*y(2) - 0.1*y(3); y(2)*y(3)];
%! y = [0.3; -0.2; 0.5; 0.7; 1];
%! turned = turned_form (system, 2, y);
%! assert (turned.state (2, turned.start), y, 1e-13);
%! h = 1e-5;
%! for t = [2 2.4]
%!   u = turned.start + 0.1*[1; -2; 3; 1; 2];
%!   r = turned.rate (t, u);
%!   moved = (turned.state (t + h, u + h*r) - turned.state (t - h, u - h*r))/(2*h);
%!   assert (moved, system.rate (t, turned.state (t, u)), 1e-7);
%! endfor
