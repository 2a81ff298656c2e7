## -*- texinfo -*-
## @deftypefn {} {@var{lines} =} spring_symbol (@var{drawing}, @var{frame}, @var{size})
## Polylines (n-by-2, m, with rows of NaN between them) of the springs of a @var{drawing} (see @code{draw_pictures}) in
## one @var{frame}: coils of a width that follows from @var{size} (m) between both ends, spirals around the first.
## @end deftypefn

function lines = spring_symbol (drawing, frame, size)
  springs = field_or (drawing, "springs", struct ("x", []));
  lines = zeros (0, 2);
  for i = 1:rows (springs.x)
    from = [springs.x(i,frame), springs.y(i,frame)];
    to = [springs.to_x(i,frame), springs.to_y(i,frame)];
    if (strcmp (springs.shape{i}, "coil"))
      line = coil (from, to, size);
    else
      line = from + size*spiral ();
    endif
    lines = [lines; line; NaN(1, 2)];
  endfor
endfunction

function line = coil (from, to, size)
  turns = 6;
  along = [0, 0.15, 0.15 + 0.7*((1:2*turns) - 0.5)/(2*turns), 0.85, 1].';
  aside = 0.45*[0, 0, (-1).^(1:2*turns), 0, 0].';
  way = to - from;
  line = from + along.*way + size*aside.*[-way(2), way(1)]/max (norm (way), realmin);
endfunction

function line = spiral ()
  angle = linspace (0, 5*pi, 60).';
  line = (0.4 + 0.7*angle/(5*pi)).*[cos(angle), sin(angle)];
endfunction

%!test # a coil from end to end, on both sides of the way, as often however far it is drawn
%! springs = struct ("x", [0 0], "y", [1 1], "to_x", [2 4], "to_y", [1 1], "shape", {{"coil"}});
%! for frame = 1:2
%!   lines = spring_symbol (struct ("springs", springs), frame, 0.1);
%!   assert (lines([1 end-1],:), [0 1; 2*frame 1], 1e-15);
%!   assert (sum (diff (sign (lines(3:end-3,2) - 1)) != 0), 11);
%!   assert ([min(lines(:,2)), max(lines(:,2))], 1 + [-0.045 0.045], 1e-15);
%! endfor
%!test # a spiral around a pin, and a spring whose ends meet
%! springs = struct ("x", [1; 0], "y", [2; 0], "to_x", [1; 0], "to_y", [2; 0], "shape", {{"spiral"; "coil"}});
%! lines = spring_symbol (struct ("springs", springs), 1, 0.1);
%! distance = hypot (lines(1:60,1) - 1, lines(1:60,2) - 2);
%! assert (distance([1 end]), [0.04; 0.11], 1e-12); assert (diff (distance) > 0);
%! assert (lines(62:end-1,:), zeros (16, 2)); assert (lines([61 end],:), NaN (2, 2));
%!assert (spring_symbol (struct (), 1, 0.1), zeros (0, 2))
