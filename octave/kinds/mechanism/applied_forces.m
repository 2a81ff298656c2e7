## -*- texinfo -*-
## @deftypefn {} {[@var{F}, @var{power}] =} applied_forces (@var{mechanism}, @var{t}, @var{at})
## Loads at the times @var{t} (1-by-k): what they do to the markers, @var{F} = struct of x, y, angle (see
## @code{forces_of_markers}), and their @var{power} (W; 1-by-k).
## @end deftypefn

function [F, power] = applied_forces (mechanism, t, at)
  k = numel (t);
  F.x = F.y = F.angle = zeros (mechanism.marker_count, k);
  power = zeros (1, k);
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

%!test # their power is that of the generalized forces
%! [system, start] = sample_mechanism ([1 2]);
%! rand ("seed", 5);
%! v = 3*rand (system.n, 1) - 1;
%! at = marker_motion (system.mechanism, start.q, v);
%! [F, power] = applied_forces (system.mechanism, 0.2, at);
%! assert (forces_of_markers (system.mechanism, at, F).'*v, power, 1e-10);
