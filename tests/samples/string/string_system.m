## -*- texinfo -*-
## @deftypefn {} {@var{system} =} string_system (@var{scene}, @var{model})
## A string of n = @var{model}.elements springs between point masses, the first one's end at O, as a system (see
## @code{integrate}) of the state (x; y; x_dot; y_dot) (4n-by-1): M q'' = weight less tension.  It starts at rest,
## straight at the angle initial.phi from the vertical, stretched as it would hang there along itself.
## @end deftypefn

function system = string_system (scene, model)
  n = model.elements;
  masses = model.rhoA*model.length/n*[ones(n-1, 1); 0.5] + model.mass*((1:n).' == n);
  spring = struct ("stiffness", n*model.stiffness, "rest", model.length/n, "weights", masses*scene.gravity);
  along = [sin(scene.initial.phi); -cos(scene.initial.phi)];
  tension = flipud (cumsum (flipud (spring.weights)))*cos (scene.initial.phi);
  lengths = spring.rest + tension/spring.stiffness;
  system.initial_state = [kron(along, cumsum (lengths)); zeros(2*n, 1)];
  system.state_scale = [ones(2*n, 1); ones(2*n, 1)/scene.duration];
  system.mass = diag ([masses; masses]);
  D = eye (n) - diag (ones (n-1, 1), -1);  # differences of neighbours
  system.stiffness = kron (along*along.', D.'*spring.stiffness*D) ...
                     + kron (eye (2) - along*along.', D.'*diag (tension./lengths)*D);
  system.rate = @(t, y) [y(2*n+1:end,:); system.mass \ forces(y, n, spring)];
  system.energies = @(y) energies (y, n, spring, system.mass, scene.duration);
  system.breaks = [];
  system.forms = {"rate"};
  system.auto = "lsode_adams";
  system.warnings = {};
  system.energy_rows = [];
  system.duration = scene.duration;
endfunction

function [dx, dy, lengths] = elements (y, n)
  dx = diff ([zeros(1, columns (y)); y(1:n,:)]);
  dy = diff ([zeros(1, columns (y)); y(n+1:2*n,:)]);
  lengths = hypot (dx, dy);
endfunction

function Q = forces (y, n, spring)
  [dx, dy, lengths] = elements (y, n);
  per_length = spring.stiffness*(lengths - spring.rest)./lengths;
  last = zeros (1, columns (y));
  Q = [diff([per_length.*dx; last]); diff([per_length.*dy; last]) - spring.weights];
endfunction

function history = energies (y, n, spring, mass, duration)
  [~, ~, lengths] = elements (y, n);
  v = y(2*n+1:end,:);
  history.T = sum (v.*(mass*v), 1)/2;
  history.U = spring.stiffness/2*sum ((lengths - spring.rest).^2, 1);
  history.Z = spring.weights.'*y(n+1:2*n,:);
  history.W = history.D = zeros (1, columns (y));
  history.balance = history.T + history.U + history.Z;
  history.energy_floor = mass(end)*(1e-6/duration)^2/2;
endfunction

%!test # it hangs at rest, and its stiffness is what the forces lose
%! scene = struct ("gravity", 9.81, "initial", struct ("phi", 0), "duration", 1);
%! system = string_system (scene, struct ("length", 1, "stiffness", 1e3, "mass", 1, "rhoA", 0.02, "elements", 3));
%! y = system.initial_state;
%! assert (system.rate (0, y), zeros (12, 1), 1e-9);
%! changed = cell2mat (arrayfun (@(k) system.rate (0, y + 1e-6*((1:12).' == k))(7:12), 1:6, ...
%!                               "uniformoutput", false));
%! assert (-system.mass*changed/1e-6, system.stiffness, 0.01);
