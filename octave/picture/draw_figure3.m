## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_figure3 (@var{drawing}, @var{scratch})
## The paper's figure 3: all of @var{drawing} (see @code{draw_pictures}) in one picture, @file{figure3.svg},
## @file{figure3.png} and @file{figure3.pdf} beside the folder @var{scratch}, which takes the data. The bodies stand
## there at up to 13 even times, shaded from the first to the last, springs as they are at the last. They are there
## when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_figure3 (drawing, scratch)
  camera = fit_camera (drawing, [790 690]);
  shown = equally_spaced (numel (drawing.time), 13);
  settings = scene_settings (drawing, camera);
  ## A single frame stands for the time that it is shown.
  settings.t = drawing.time(1) + [0, max(drawing.time(end) - drawing.time(1), 1/drawing.frames_per_second)];
  settings.t_step = tic_step (settings.t, 8);
  [settings.t_scale, settings.t_unit] = axis_unit (settings.t, "s");
  settings.duration = sprintf ("%.4g %s", range (drawing.time)/settings.t_scale, settings.t_unit);

  outlines = rests = {};
  pins = [];
  for frame = shown
    for body = drawing.bodies(:).'
      half_height = max (body.half_height, 1.5*camera.pixel);
      outlines{end+1} = body_outline (body.x(:,frame), body.y(:,frame), half_height);
      rests{end+1} = [body.rest_x(:,frame), body.rest_y(:,frame)];
      times(numel (outlines)) = drawing.time(frame);
    endfor
    [ground, pin] = hinge_symbol (drawing.hinges, frame, camera.symbol);
    pins = [pins; pin];
    springs = spring_symbol (drawing, frame, camera.symbol);
  endfor
  settings.outlines = numel (outlines);
  settings.times = num2cell (times);
  write_text (fullfile (scratch, "settings.gp"),
              [gnuplot_settings(settings), gnuplot_block("outlines", outlines), gnuplot_block("rests", rests), ...
               gnuplot_block("tip_path", {tip_path(drawing.bodies)}), gnuplot_block("ground", {ground}), ...
               gnuplot_block("pins", {pins}), gnuplot_block("springs", {springs})]);
  job = start_gnuplot (scratch, "figure3.gp");
endfunction

%!function check_files (drawing, folder, scratch)
%!  finish_tool (draw_figure3 (drawing, scratch));
%!  for name = {"figure3.svg", "figure3.png", "figure3.pdf"}
%!    assert (stat (fullfile (folder, name{1})).size > 1000);
%!  endfor
%!endfunction

%!test in_scratch (@(folder, scratch) check_files (sample_drawing (30), folder, scratch));
%!test # a single frame
%! in_scratch (@(folder, scratch) check_files (sample_drawing (1), folder, scratch));
%!function text = settings_of (drawing, scratch)
%!  finish_tool (draw_figure3 (drawing, scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # thirteen even times with their outlines and rests, from the first frame to the last
%! drawing = sample_drawing (25);
%! drawing.time += 3;
%! text = in_scratch (@(folder, scratch) settings_of (drawing, scratch));
%! value = @(name) str2num (regexp (text, ['(?<=\n)' name ' = ([^\n]*)'], "tokens", "once"){1});
%! assert (value ("outlines"), 13); assert (value ("array times\\[13\\]"), drawing.time(1:2:25), 1e-9);
%! assert ([value("t_low"), value("t_high")], drawing.time([1 end]), 1e-9);
%! assert (! isempty (strfind (text, sprintf ("duration = '%.4g s'\n", range (drawing.time)))));
%! blocks = @(name) strsplit (regexp (text, ['\$' name ' << END\n(.*?)\nEND'], "tokens", "once"){1}, "\n\n\n");
%! rests = blocks ("rests");
%! assert (numel (rests), 13); assert (numel (blocks ("outlines")), 13);
%! assert (str2num (rests{13}), [drawing.bodies.rest_x(:,25), drawing.bodies.rest_y(:,25)], 1e-6);
%! outline = str2num (blocks ("outlines"){2});
%! half_height = max (0.015, 1.5*fit_camera (drawing, [790 690]).pixel);
%! middle = (outline(1:41,:) + flipud (outline(42:82,:)))/2;
%! assert (middle, [drawing.bodies.x(:,3), drawing.bodies.y(:,3)], 1e-6);
%! assert (hypot (outline(1,1) - middle(1,1), outline(1,2) - middle(1,2)), half_height, 1e-6);
%! assert (numel (regexp (blocks ("pins"){1}, '\n\n')), 12);
%! text = in_scratch (@(folder, scratch) settings_of (sample_drawing (1), scratch));
%! shown = regexp (text, 't_low = (\S+)\nt_high = (\S+)\n', "tokens", "once");
%! assert (diff (cellfun (@str2double, shown)), 1/50, 1e-9);  # as long as a frame is shown
