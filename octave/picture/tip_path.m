## -*- texinfo -*-
## @deftypefn {} {[@var{path}, @var{pieces}] =} tip_path (@var{bodies})
## The path of the end of the last of the @var{bodies} (see @code{draw_pictures}), m-by-2 (m), smooth where the frames
## are dense enough to tell its way between them: so many @var{pieces} a frame, on cubic splines.
## @end deftypefn

function [path, pieces] = tip_path (bodies)
  path = [bodies(end).x(end,:); bodies(end).y(end,:)].';
  frames = rows (path);
  pieces = 1;
  way = diff (complex (path(:,1), path(:,2)));
  turns = sort (abs (arg (way(2:end)./way(1:end-1))));
  turns(isnan (turns)) = 0;
  if (frames > 4 && turns(ceil (0.95*end)) < 0.8)
    pieces = min (8, max (1, ceil (turns(ceil (0.95*end))/0.06)));
    path = spline (1:frames, path.', linspace (1, frames, (frames - 1)*pieces + 1)).';
  endif
endfunction

%!test # a circle of 20 frames comes out round
%! angle = 2*pi*(0:20)/20;
%! [path, pieces] = tip_path (struct ("x", cos (angle), "y", sin (angle)));
%! assert (pieces, 6);
%! assert (hypot (path(:,1), path(:,2)), ones (121, 1), 1e-3);
%!test # no way is made up between frames that know none, and none where nothing moves
%! [path, pieces] = tip_path (struct ("x", (-1).^(1:9), "y", 0.1*(1:9)));
%! assert (pieces, 1); assert (path(:,2), 0.1*(1:9).');
%! assert (nthargout (2, @tip_path, struct ("x", zeros (1, 9), "y", zeros (1, 9))), 1);
