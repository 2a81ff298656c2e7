## -*- texinfo -*-
## @deftypefn {} {@var{text} =} frame_data (@var{drawing}, @var{stress}, @var{camera}, @var{frame})
## What one @var{frame} shows, as variables and data blocks of gnuplot: the clock, the moment's arrow, the hinges, the
## tip's path, and an index for each body in $rest, $outline and $centreline. The last has the @var{stress} as its third
## column, NaN where there is none.
## @end deftypefn

function text = frame_data (drawing, stress, camera, frame)
  bodies = drawing.bodies;
  for i = 1:numel (bodies)
    x = bodies(i).x(:,frame);
    y = bodies(i).y(:,frame);
    rest{i} = [bodies(i).rest_x(:,frame), bodies(i).rest_y(:,frame)];
    outline{i} = body_outline (x, y, drawn_half_height (bodies(i), camera));
    centreline{i} = [x, y, body_colour(stress{i}, frame, numel (x))];
  endfor
  path = [bodies(end).x(end,1:frame); bodies(end).y(end,1:frame)].';
  [ground, pins] = hinge_symbol (drawing.hinges, frame, camera.symbol);

  moment = drawing.moment(frame);
  hinge = [drawing.hinges.x(1,frame), drawing.hinges.y(1,frame)];
  [arrow, place] = moment_arrow (moment, hinge, free_direction (bodies, hinge, frame), 3 * camera.symbol);

  settings.clock = sprintf ("t = %.*f s", clock_digits (drawing.frames_per_second), drawing.time(frame));
  settings.moment_label = ifelse_text (moment, sprintf ("M = %.3g N m", moment));
  text = [gnuplot_settings(settings), ...
          gnuplot_block("rest", rest), gnuplot_block("outline", outline), gnuplot_block("centreline", centreline), ...
          gnuplot_block("path", {path}), gnuplot_block("ground", {ground}), gnuplot_block("pins", {pins}), ...
          gnuplot_block("moment", {arrow, place})];
endfunction
