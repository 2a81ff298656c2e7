## -*- texinfo -*-
## @deftypefn {} {[@var{arrows}, @var{label}, @var{text}] =} moment_arrows (@var{drawing}, @var{frame}, @var{camera})
## Polylines (n-by-2, m, with rows of NaN between them) of the moments of a @var{drawing} (see @code{draw_pictures}) in
## one @var{frame}: around the first hinge, away from the bodies, and above the others' places; and where (1-by-2, m)
## the largest one has its @var{text}, "" where there is none.
## @end deftypefn

function [arrows, label, text] = moment_arrows (drawing, frame, camera)
  [centres, away, moments] = acting (drawing, frame);
  arrows = zeros (0, 2);
  label = [0 0];
  text = "";
  [~, largest] = max (abs (moments));
  for i = find (moments(:).' != 0)
    [arrow, place] = moment_arrow (moments(i), centres(i,:), atan2 (away(i,2), away(i,1)), 3*camera.symbol);
    arrows = [arrows; arrow; NaN(1, 2)];
    if (i == largest)
      [scale, unit] = unit_prefix (moments(i), "N m");
      text = sprintf ("%.3g %s", moments(i)/scale, unit);
      label = place + [5.5*numel(text), 11]*camera.pixel.*away(i,:);
    endif
  endfor
endfunction

function [centres, away, moments] = acting (drawing, frame)
  middle = mean (cell2mat (arrayfun (@(body) [body.rest_x(:,frame), body.rest_y(:,frame)], drawing.bodies(:), ...
                                     "uniformoutput", false)));
  centres = middle;
  away = [0 1];
  if (! isempty (drawing.hinges.x))
    centres = [drawing.hinges.x(1,frame), drawing.hinges.y(1,frame)];
    away = (centres - middle)/max (norm (centres - middle), realmin);
  endif
  moments = drawing.moment(frame);
  if (isfield (drawing, "moments"))
    of_joints = drawing.moments;
    centres = [centres; of_joints.x(:,frame), of_joints.y(:,frame)];
    away = [away; repmat([0 1], rows (of_joints.x), 1)];
    moments = [moments; of_joints.M(:,frame)];
  endif
endfunction

%!test # the moment around O on the side that the rod is not, with its size while it acts
%! drawing = sample_drawing (19);
%! camera = struct ("symbol", 0.1, "pixel", 0.001);
%! [arrows, label, text] = moment_arrows (drawing, 2, camera);
%! assert (text, "30 N m"); assert (hypot (arrows(1:40,1), arrows(1:40,2)), 0.3*ones (40, 1), 1e-12);
%! middle = [mean(drawing.bodies.rest_x(:,2)), mean(drawing.bodies.rest_y(:,2))];
%! assert (label*middle.' < 0);
%! [arrows, ~, text] = moment_arrows (drawing, 9, camera);
%! assert (arrows, zeros (0, 2)); assert (text, "");
%!test # and those of joints above them; the largest has its size
%! drawing = sample_drawing (19);
%! drawing.moments = struct ("x", [1; 2].*ones (1, 19), "y", zeros (2, 19), "M", [5; -4e4].*ones (1, 19));
%! [arrows, label, text] = moment_arrows (drawing, 9, struct ("symbol", 0.1, "pixel", 0.001));
%! assert (rows (arrows), 90); assert (text, "-40 kN m"); assert (label(1), 2, 1e-12); assert (label(2) > 0.4);
