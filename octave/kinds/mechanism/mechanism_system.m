## -*- texinfo -*-
## @deftypefn {} {@var{system} =} mechanism_system (@var{scene}, @var{mechanism})
## A mechanism as its integrators see it: M (q) q'' + Phi_q' lambda = f (t, q, q'), Phi (t, q) = 0, from
## L - lambda Phi.
##
## Fields: n, constraint_count, stiffness, damping_matrix (n-by-n, constant), mass (n-by-n, of the bodies
## as they are made), duration, breaks, forms, auto, q_scale (m: what each coordinate may be off by where a point is
## off by 1 m), q_points (see @code{points_of_coordinates}), and, for times t (1-by-k) and states q, v (n-by-k),
##
## @table @code
## @item at (t, q, v)
## a struct with all below in it: force (f), power, dissipated (W), constraints (see @code{joint_constraints}) and
## springs (see @code{spring_forces})
## @item prescribed (t)
## what joints and loads prescribe then: at takes it in the place of t, where it is asked again and again
## @item work_rate (at, lambda)
## the rate of the work W of the loads and of joints that move (1-by-k, W): power + lambda' Phi_t
## @item inertia (at, a), reaction (at, lambda), spring_reaction (at, tension)
## M a, Phi_q' lambda and the same of the springs, whose part of f is minus that of their tension
## @item tangent (at, lambda, tension)
## minus the derivative of f - Phi_q' lambda by q, less what inertia forces have in it and less that of the tensions
## themselves (sparse n-by-n, a block a state along the diagonal)
## @item on_markers (at, lambda)
## what joints and loads do to the markers: a struct of x, y (N) and angle (N m; markers-by-k)
## @item constraint_convection (at, v)
## what Phi'' is without accelerations (constraints-by-k)
## @item convection (at, v)
## (dM/dt) v: with f it is dL/dq of one state
## @item matrices (at)
## M, Phi_q and the derivatives of the springs' elongations, likewise
## @item energies (q, v, at)
## [T; U; Z]
## @item steepest (q)
## [slope, strain], the largest of bodies that are not geometrically exact, and of all, in a state
## @end table
## @end deftypefn

function system = mechanism_system (scene, mechanism)
  system.mechanism = mechanism;
  system.n = mechanism.n;
  system.constraint_count = mechanism.constraints.count;
  system.duration = scene.duration;
  system.breaks = scene.breaks;
  system.forms = {"constrained"};
  system.auto = "radau";
  system.stiffness = system.damping_matrix = sparse (system.n, system.n);
  system.q_scale = ones (system.n, 1);
  for group = mechanism.groups
    n = rows (group.index) - 3;
    system.q_scale(group.index(n+1,:)) = 1/group.model.length;
    for index = group.index
      system.stiffness(index(1:n),index(1:n)) = group.model.arrays.stiffness_matrix;
      system.damping_matrix(index(1:n),index(1:n)) = group.model.arrays.damping*group.model.arrays.stiffness_matrix;
    endfor
  endfor
  system.q_points = points_of_coordinates (mechanism);
  q = v = zeros (system.n, 1);
  system.mass = mechanism_matrices (mechanism, rod_dynamics (mechanism, q, v));
  system.prescribed = @(t) prescribed_at (mechanism, t);
  system.at = @(t, q, v) everything (mechanism, t, q, v);
  system.work_rate = @(at, lambda) at.power + sum (lambda.*at.constraints.rate, 1);
  system.inertia = @(at, a) inertia_times (mechanism, at.rods, a);
  system.reaction = @(at, lambda) forces_of_markers (
    mechanism, at.markers, reactions (mechanism, mechanism.constraints, at.constraints, lambda));
  system.spring_reaction = @(at, tension) forces_of_markers (
    mechanism, at.markers, reactions (mechanism, mechanism.springs, at.springs, tension));
  system.tangent = @(at, lambda, tension) along_diagonal (system.stiffness, at);
  if (! isempty (mechanism.loads) || mechanism.springs.count > 0)  # weight and joints alone need no more
    system.tangent = @(at, lambda, tension) along_diagonal (system.stiffness, at) + geometric_stiffness (
      mechanism, at.q, forces_on_markers (mechanism, at, lambda, tension));
  endif
  system.on_markers = @(at, lambda) forces_on_markers (mechanism, at, lambda, at.springs.tension);
  system.constraint_convection = @(at, v) constraint_convection (
    mechanism.constraints, at.prescribed, at.markers, at.constraints, marker_convection (mechanism, at.q, v));
  system.convection = @(at, v) rod_convection (mechanism, at.q, v);
  system.matrices = @(at) mechanism_matrices (mechanism, at.rods, at.markers, at.constraints, at.springs);
  largest = arrayfun (@(group) largest_slopes (group.model, group.model.basis), mechanism.groups, ...
                      "uniformoutput", false);
  system.steepest = @(q) steepest (mechanism.groups, largest, q);
  system.energies = @(q, v, at) mechanism_energies (mechanism, q, v) + [0; 1; 0]*at.springs.energy;
endfunction

## slope of all bodies whose models hold for small ones, strain of all
function [slope, strain] = steepest (groups, largest, q)
  slope = strain = 0;
  for k = 1:numel (groups)
    group = groups(k);
    [across, along] = largest{k} (reshape (q(group.index(1:end-3,:)), [], columns (group.index)));
    strain = max (strain, along);
    if (! strcmp (group.model.rung.stiffening, "exact"))
      slope = max (slope, across);
    endif
  endfor
endfunction

function prescribed = prescribed_at (mechanism, t)
  prescribed = struct ("t", t, "constraints", {prescribed_values(mechanism.constraints, t)}, ...
                       "loads", {applied_values(mechanism.loads, t)});
endfunction

function at = everything (mechanism, t, q, v)
  if (isnumeric (t))
    t = prescribed_at (mechanism, t);
  endif
  at.q = q;
  at.prescribed = t.constraints;
  at.rods = rod_dynamics (mechanism, q, v);
  at.markers = markers_of_states (mechanism, q, v);
  at.constraints = joint_constraints (mechanism.constraints, t.constraints, at.markers);
  at.springs = spring_forces (mechanism, at.markers);
  [at.loads, at.power] = applied_forces (mechanism, t.loads, at.markers);
  F = forces_on_markers (mechanism, at, 0*at.constraints.residual, at.springs.tension);
  at.force = at.rods.force + forces_of_markers (mechanism, at.markers, F);
  at.dissipated = at.rods.dissipated + at.springs.dissipated;
endfunction

## the same of every state
function K = along_diagonal (K, at)
  K = kron (speye (columns (at.q)), K);
endfunction

function F = forces_on_markers (mechanism, at, lambda, tension)
  tie = reactions (mechanism, mechanism.constraints, at.constraints, lambda);
  pull = reactions (mechanism, mechanism.springs, at.springs, tension);
  for part = {"x", "y", "angle"}
    F.(part{1}) = at.loads.(part{1}) - tie.(part{1}) - pull.(part{1});
  endfor
endfunction

%!test # several times at once
%! [system, q, v] = sample_state ();
%! both = system.at ([0.1 0.2], [q, q], [v, -v]);
%! assert (both.force(:,2), system.at (0.2, q, -v).force, 1e-10);
%!test # what forces turn their sign with the velocity take is dissipated, by rods and by dampers
%! [system, q, v] = sample_state ();
%! [ahead, back] = deal (system.at (0.1, q, v), system.at (0.1, q, -v));
%! assert (v.'*(ahead.force - back.force)/2, -ahead.dissipated, 1e-9*ahead.dissipated);
%! assert (ahead.rods.dissipated > 0.01*ahead.dissipated && ahead.springs.dissipated > 0.01*ahead.dissipated);
%!test # the power of a joint that moves is the rate of the energies
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e4, "EI", 5, "rhoA", 1), "model", struct ("modes", [1 2]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
%!                 struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [0.3 + 2*t + t^2/2, 2 + t, 1])};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! start = assemble_mechanism (scene, system.mechanism, system);
%! [a, lambda, at] = constrained_accelerations (system, 0, start.q, start.v);
%! E = @(h) sum (mechanism_energies (system.mechanism, start.q + h*start.v + h^2/2*a, start.v + h*a));
%! power = system.work_rate (at, lambda);
%! assert ((E (1e-5) - E (-1e-5))/2e-5, power, 1e-6*abs (power)); assert (abs (power) > 1);
