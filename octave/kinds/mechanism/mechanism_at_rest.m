## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} mechanism_at_rest (@var{scene}, @var{mechanism})
## The balance of forces of a checked scene's @var{mechanism}, as @code{equilibrium} and @code{vibrations} take it: a
## struct of
##
## @table @code
## @item n, multipliers
## numbers of coordinates q and of multipliers
## @item start
## coordinates (n-by-1) near which an equilibrium is looked for: where the bodies are placed
## @item residual (t, q, v, lambda)
## forces less Phi_q' lambda, and the constraints (n + multipliers by k) at a time, or at k times, and k states
## @item tangent (t, q, lambda)
## the stiffness: minus the derivative of the forces by q, and below it that of the constraints
## @item damping (t, q, lambda)
## minus the derivative of the forces by v at rest (n-by-n)
## @item mass (q)
## the mass matrix (n-by-n)
## @item size (step)
## the largest displacement (m) that goes with a small change of q, on rods of the length (m)
## @item steps
## changes of the coordinates that move a point by a ten-thousandth of the longest rod (n-by-1)
## @item shape (q)
## centrelines of k coordinates: a cell array, a body each, of [x y] (places-by-2-by-k, m)
## @item supports (t, q, lambda)
## what holds the bodies at rest: rows of a name, with its unit, and a number, as columns of history.csv have them
## @item along (t, q, lambda)
## forces and moments in the rods' sections at the places of shape: a cell array, a body each, of a struct of columns
## (see @code{section_forces})
## @item accelerations (t, q, v)
## of a motion: [a, lambda], accelerations and multipliers
## @item moving (t, q, v, a, lambda)
## forces less Phi_q' lambda and less inertia (n-by-k), and the constraints
## @item jacobian (q)
## Phi_q (multipliers-by-n)
## @item interpolation
## what the coordinates move (see @code{points_of_coordinates}), at 41 places of each body
## @item most
## the largest number of base functions that is of use
## @item steepest (q)
## [slope, strain], the largest of bodies that are not geometrically exact, and of all
## @item bodies
## the coordinates of each body: a cell array, with names, a cellstr
## @end table
## @end deftypefn

function balance = mechanism_at_rest (scene, mechanism)
  system = mechanism_system (scene, mechanism);
  balance.n = system.n;
  balance.multipliers = system.constraint_count;
  balance.start = placed_bodies (scene, mechanism);
  balance.residual = @(t, q, v, lambda) residual (system, t, q, v, lambda);
  balance.mass = @(q) full (mechanism_matrices (mechanism, rod_dynamics (mechanism, q, 0*q)));
  balance.size = @(step) max (abs (step)./system.q_scale);
  balance.length = max (cellfun (@(model) model.length, mechanism.models));
  balance = with_derivatives (balance, 1e-4*balance.length*system.q_scale);
  balance.shape = @(q) shape (mechanism, q);
  balance.supports = @(t, q, lambda) supports (system, scene, t, q, lambda);
  balance.along = @(t, q, lambda) section_forces (system, scene, t, q, lambda);
  balance.accelerations = @(t, q, v) constrained_accelerations (system, t, q, v);
  balance.moving = @(t, q, v, a, lambda) moving (system, t, q, v, a, lambda);
  balance.jacobian = @(q) jacobian_at (system, q);
  balance.most = 32;
  balance.steepest = system.steepest;
  balance.interpolation = full (points_of_coordinates (mechanism, 41));
  for k = 1:numel (mechanism.models)
    balance.bodies{k} = index_of (mechanism, k);
    balance.names{k} = scene.bodies(k).name;
  endfor
endfunction

function r = residual (system, t, q, v, lambda)
  at = system.at (t.*ones (1, columns (q)), q, v);
  r = [at.force - system.reaction(at, repmat (lambda, 1, columns (q))); at.constraints.residual];
endfunction

function [f, off] = moving (system, t, q, v, a, lambda)
  at = system.at (t.*ones (1, columns (q)), q, v);
  f = at.force - system.inertia (at, a) - system.reaction (at, repmat (lambda, 1, columns (q)));
  off = at.constraints.residual;
endfunction

function J = jacobian_at (system, q)
  [~, J] = system.matrices (system.at (0, q, 0*q));
  J = full (J);
endfunction

function rows = supports (system, scene, t, q, lambda)
  forces = joint_forces (system.mechanism, system.at (t, q, 0*q), lambda);
  rows = cell (0, 2);
  for j = find (! is_load (scene.joints))
    name = scene.joints(j).name;
    rows = [rows; {["reaction_x of " name " [N]"], forces(j).reaction_x
                   ["reaction_y of " name " [N]"], forces(j).reaction_y
                   ["torque of " name " [N m]"], forces(j).torque}];
  endfor
endfunction

function lines = shape (mechanism, q)
  for k = 1:numel (mechanism.models)
    model = mechanism.models{k};
    own = q(index_of (mechanism, k),:);
    [x, y] = body_centreline (model, linspace (0, model.length, 41), motion_of_rods (own, 0*own), 1);
    lines{k} = permute (cat (3, x, y), [1 3 2]);
  endfor
endfunction

%!test # forces and constraints as the system has them; shapes are those of the bodies
%! [system, start, scene] = sample_mechanism ([1 2]);
%! balance = mechanism_at_rest (scene, system.mechanism);
%! lambda = (1:balance.multipliers).';
%! at = system.at (0.1, start.q, start.v);
%! assert (balance.residual (0.1, start.q, start.v, 0*lambda), [at.force; at.constraints.residual], 1e-12);
%! assert (balance.residual (0.1, start.q, start.v, lambda)(1:balance.n), at.force - system.reaction (at, lambda), 1e-12);
%! assert (numel (balance.bodies{2}), balance.n/3); assert (size (balance.shape (start.q){3}), [41 2]);
%! assert (balance.shape ([0*start.q, start.q]){2}(:,:,2), balance.shape (start.q){2}, 1e-15);
%! assert (balance.mass (start.q), full (system.matrices (at)), 1e-12);
