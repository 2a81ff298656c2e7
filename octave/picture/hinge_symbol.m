## -*- texinfo -*-
## @deftypefn {} {[@var{ground}, @var{pins}] =} hinge_symbol (@var{hinges}, @var{frame}, @var{size})
## Polylines (n-by-2, m, with rows of NaN between them) of the hinges in one @var{frame}: @var{pins} are the circles,
## @var{ground} the hatched supports of O and of all other hinges that never move.
## @end deftypefn

function [ground, pins] = hinge_symbol (hinges, frame, size)
  moves = any (hinges.x != hinges.x(:,1), 2) | any (hinges.y != hinges.y(:,1), 2);
  ## A single frame cannot tell which hinges move: only O is known to be fixed.
  fixed = ! moves & columns (hinges.x) > 1;
  fixed(1) = true;
  angle = linspace (0, 2*pi, 25).';
  circle = [cos(angle), sin(angle)] * 0.4;
  ground = pins = zeros (0, 2);
  for i = 1:numel (moves)
    place = [hinges.x(i,frame), hinges.y(i,frame)];
    pins = [pins; place + size * circle; NaN(1, 2)];
    if (fixed(i))
      ground = [ground; place + size * support(); NaN(1, 2)];
    endif
  endfor
endfunction

function lines = support ()
  lines = [0 0; -1 -1.6; 1 -1.6; 0 0; NaN NaN; -1.4 -1.6; 1.4 -1.6];
  for foot = -1:0.6:1.4
    lines = [lines; NaN NaN; foot -1.6; foot-0.5 -2.1];
  endfor
endfunction

%!test # O has a support, a hinge that moves has none
%! hinges = struct ("x", [0 0; 1 2], "y", [0 0; 0 0]);
%! [ground, pins] = hinge_symbol (hinges, 2, 0.1);
%! assert (max (ground(:,1)) < 1);
%! assert (max (pins(:,1)), 2.04, 1e-12);
