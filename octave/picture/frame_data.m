## -*- texinfo -*-
## @deftypefn {} {@var{text} =} frame_data (@var{drawing}, @var{stress}, @var{camera}, @var{frame}, @var{tip})
## What one @var{frame} shows, as variables and data blocks of gnuplot: the clock, the number @var{tip} of the last point
## of the tip's path (see @code{with_path}), the hinges, springs, forces and moments, and an index for each body in
## $rest and $outline. $pieces has an index for each body with a @var{stress} (see @code{body_stress}): start, extent and
## stress of pieces of its centreline.
## @end deftypefn

function text = frame_data (drawing, stress, camera, frame, tip = 0)
  bodies = drawing.bodies;
  pieces = {};
  for i = 1:numel (bodies)
    centre = [bodies(i).x(:,frame), bodies(i).y(:,frame)];
    rest{i} = [bodies(i).rest_x(:,frame), bodies(i).rest_y(:,frame)];
    outline{i} = body_outline (centre(:,1), centre(:,2), max (bodies(i).half_height, 1.5*camera.pixel));
    if (! isempty (stress{i}))
      ## Each piece reaches over the next one too, which covers it: so no seams show.
      reach = centre([3:end, end, end],:) - centre;
      of_points = [centre, reach, stress{i}(:,frame)];
      pieces{end+1} = of_points(1:end-1,:);
    endif
  endfor
  [ground, pins] = hinge_symbol (drawing.hinges, frame, camera.symbol);
  springs = spring_symbol (drawing, frame, camera.symbol);

  [arrows, settings.force_place, settings.force_label] = force_arrows (drawing, frame, camera);
  [arcs, settings.moment_place, settings.moment_label] = moment_arrows (drawing, frame, camera);
  settings.clock = clock_text (drawing, frame);
  settings.tip = tip;
  text = [gnuplot_settings(settings), ...
          gnuplot_block("rest", rest), gnuplot_block("outline", outline), gnuplot_block("pieces", pieces), ...
          gnuplot_block("moments", {arcs}), gnuplot_block("ground", {ground}), gnuplot_block("pins", {pins}), ...
          gnuplot_block("springs", {springs}), gnuplot_block("forces", {arrows})];
endfunction

%!function text = data_of (drawing, frame)
%!  text = frame_data (drawing, body_stress (drawing.bodies), fit_camera (drawing, [4 3]), frame);
%!endfunction

%!test # the moment is named while it acts
%! drawing = sample_drawing (19);
%! assert (! isempty (strfind (data_of (drawing, 2), "moment_label = '30 N m'")));
%! assert (! isempty (strfind (data_of (drawing, 9), "moment_label = ''")));
%!test # a piece between two points of the body, with its stress at the first, reaches over the next one
%! drawing = sample_drawing (19);
%! text = data_of (drawing, 2);
%! block = regexp (text, '\$pieces << END\n(.*?)\nEND', "tokens", "once"){1};
%! pieces = str2num (block);
%! assert (size (pieces), [40 5]);
%! [x, y] = deal (drawing.bodies.x(:,2), drawing.bodies.y(:,2));
%! assert (pieces(:,1:2), [x, y](1:40,:), 1e-6); assert (pieces(:,1:2) + pieces(:,3:4), [x, y]([3:41, 41],:), 1e-6);
%! assert (pieces(:,5), body_stress (drawing.bodies){1}(1:40,2), 1e-6*max (pieces(:,5)));
%! assert (numel (strfind (text, "$rest << END")), 1); assert (numel (strfind (text, "$outline << END")), 1);
%! place = cellfun (@(end_of) str2double (regexp (text, ["moment_place_" end_of " = (\\S+)"], "tokens", ...
%!   "once"){1}), ...
%!                  {"low", "high"});
%! middle = [mean(drawing.bodies.rest_x(:,2)), mean(drawing.bodies.rest_y(:,2))];
%! assert (place*middle.' < 0);  # O is the origin: the label is on the side that the rod is not
