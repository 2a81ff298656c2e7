## -*- texinfo -*-
## @deftypefn {} {[@var{F}, @var{energy}, @var{power}, @var{dissipated}] =} applied_forces (@var{mechanism}, @var{t}, @var{at})
## Springs and loads at the times @var{t} (1-by-k): what they do to the markers, @var{F} = struct of x, y, angle (see
## @code{forces_of_markers}), the springs' @var{energy} (J), the loads' @var{power} and the dampers' (W; 1-by-k each).
## @end deftypefn

function [F, energy, power, dissipated] = applied_forces (mechanism, t, at)
  k = numel (t);
  [F.x, F.y, F.angle] = deal (zeros (mechanism.marker_count, k));
  [energy, power, dissipated] = deal (zeros (1, k));
  for spring = mechanism.springs
    [p, s] = deal (spring.first, spring.second);
    every = ones (1, k);
    [E, D, x_1, y_1, a_1, x_2, y_2, a_2] = spring.form (
      at.x(p,:), at.y(p,:), at.angle(p,:), at.x(s,:), at.y(s,:), at.angle(s,:), ...
      at.x_dot(p,:), at.y_dot(p,:), at.angle_dot(p,:), at.x_dot(s,:), at.y_dot(s,:), at.angle_dot(s,:), ...
      spring.stiffness*every, spring.damping*every, spring.rest*every);
    energy += sum (E, 1);
    dissipated += sum (D, 1);
    for i = 1:numel (p)
      F = add_to (F, p(i), [x_1(i,:); y_1(i,:); a_1(i,:)]);
      F = add_to (F, s(i), [x_2(i,:); y_2(i,:); a_2(i,:)]);
    endfor
  endfor
  for load = mechanism.loads
    f = zeros (3, k);
    for i = 1:k
      f(load.parts,i) = load.value (t(i));
    endfor
    F = add_to (F, load.first, f);
    F = add_to (F, load.second, -f);
    rate = @(of) [at.x_dot(of,:); at.y_dot(of,:); at.angle_dot(of,:)];
    power += sum (f.*(rate (load.first) - rate (load.second)), 1);
  endfor
endfunction

function F = add_to (F, marker, f)
  F.x(marker,:) += f(1,:);
  F.y(marker,:) += f(2,:);
  F.angle(marker,:) += f(3,:);
endfunction

%!function [system, q, v, h] = any_state ()
%!  [system, start] = sample_mechanism ([1 2]);
%!  rand ("seed", 5);
%!  [q, v, h] = deal (start.q + 0.01*rand (system.n, 1), 3*rand (system.n, 1) - 1, 1e-6);
%!endfunction
%!test # springs' forces are their energy's gradients, less the dampers'
%! [system, q, v, h] = any_state ();
%! energy = @(s) nthargout (2, @applied_forces, system.mechanism, 0.2, marker_motion (system.mechanism, q + s*v, v));
%! at = marker_motion (system.mechanism, q, v);
%! [F, ~, power, dissipated] = applied_forces (system.mechanism, 0.2, at);
%! assert (forces_of_markers (system.mechanism, at, F).'*v, power - dissipated - (energy (h) - energy (-h))/(2*h), 1e-6);
