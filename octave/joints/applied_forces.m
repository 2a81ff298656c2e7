## -*- texinfo -*-
## @deftypefn {} {[@var{F}, @var{power}] =} applied_forces (@var{mechanism}, @var{values}, @var{at})
## Loads of the @var{values} F_x, F_y, M (a cell a load, 3-by-k) in the markers' motion @var{at}: what they do to the
## markers, @var{F} = struct of x, y, angle (see @code{forces_of_markers}), and their @var{power} (W; 1-by-k).
## @end deftypefn

function [F, power] = applied_forces (mechanism, values, at)
  F.x = F.y = F.angle = zeros (size (at.x));
  power = zeros (1, columns (at.x));
  for j = 1:numel (mechanism.loads)
    load = mechanism.loads(j);
    F = add_to (F, load.first, values{j});
    F = add_to (F, load.second, -values{j});
    rate = @(of) [at.x_dot(of,:); at.y_dot(of,:); at.angle_dot(of,:)];
    power += sum (values{j}.*(rate (load.first) - rate (load.second)), 1);
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
%! at = markers_of_states (system.mechanism, start.q, v);
%! [F, power] = applied_forces (system.mechanism, {[0.2; 1; 0]}, at);
%! assert (forces_of_markers (system.mechanism, at, F).'*v, power, 1e-10);
