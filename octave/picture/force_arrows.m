## -*- texinfo -*-
## @deftypefn {} {[@var{arrows}, @var{label}, @var{text}] =} force_arrows (@var{drawing}, @var{frame}, @var{camera})
## Polylines (n-by-2, m, with rows of NaN between them) of the forces of a @var{drawing} (see @code{draw_pictures}) in
## one @var{frame}, which end where they act and are as long as @code{force_tails} says for symbols as the @var{camera}
## has them (see @code{fit_camera}); and where (1-by-2, m) the largest of this frame has its @var{text}, "" where there
## is none.
## @end deftypefn

function [arrows, label, text] = force_arrows (drawing, frame, camera)
  size = camera.symbol;
  arrows = zeros (0, 2);
  label = [0 0];
  text = "";
  [x, y] = force_tails (drawing, size);
  largest = 0;
  for i = 1:rows (x)
    tail = [x(i,frame), y(i,frame)];
    tip = [drawing.forces.x(i,frame), drawing.forces.y(i,frame)];
    way = tip - tail;
    if (norm (way) < size/20)
      continue;
    endif
    along = size*way/norm (way);
    barb = @(side) tip - 0.8*along + side*0.35*[-along(2), along(1)];
    arrows = [arrows; tail; tip; NaN(1, 2); barb(1); tip; barb(-1); NaN(1, 2)];
    if (norm (way) > largest)
      largest = norm (way);
      newtons = hypot (drawing.forces.F_x(i,frame), drawing.forces.F_y(i,frame));
      [scale, unit] = unit_prefix (newtons, "N");
      text = sprintf ("%.3g %s", newtons/scale, unit);
      label = tail - ([5.5*numel(text), 11]*camera.pixel + size/4).*along/size;
    endif
  endfor
endfunction

%!function drawing = of_forces (x, y, F_x, F_y)
%!  drawing.forces = struct ("x", x, "y", y, "F_x", F_x, "F_y", F_y);
%!endfunction
%!test # the largest of all frames is six symbols long, and what does not act is not there
%! drawing = of_forces ([1 1; 5 5], [2 2; 6 6], [0 0; 0 3], [-2000 -1000; 0 0]);
%! camera = struct ("symbol", 0.1, "pixel", 0.001);
%! [arrows, label, text] = force_arrows (drawing, 1, camera);
%! assert (arrows([1 2 5],:), [1 2.6; 1 2; 1 2], 1e-12); assert (label, [1 2.6 + 0.011 + 0.025], 1e-12); assert (text, "2 kN");
%! assert (arrows([4 6],:), [1 + [0.035; -0.035], [2.08; 2.08]], 1e-12);
%! [arrows, ~, text] = force_arrows (drawing, 2, camera);
%! assert (arrows(1:2,:), [1 2.3; 1 2], 1e-12); assert (text, "1 kN"); assert (rows (arrows), 7);
%!test
%! [arrows, ~, text] = force_arrows (struct (), 1, struct ("symbol", 0.1));
%! assert (arrows, zeros (0, 2)); assert (text, "");
