## -*- texinfo -*-
## @deftypefn {} {@var{text} =} strip_data (@var{drawing})
## The strips beside the frames of @var{drawing} (see @code{draw_pictures}) for @file{strips.gp}: $history, the time
## and all curves at each frame, or, of more than 4000 frames, at each of a stride of them, the time's range, step and
## unit, and what each strip has, as arrays (see @code{strip_names}).
## @end deftypefn

function text = strip_data (drawing)
  time.t = padded_range (drawing.time);
  time.t_step = tic_step (time.t, 6);
  [time.t_scale, time.t_unit] = axis_unit (time.t, "s");
  if (numel (sprintf ("%g", time.t_step/time.t_scale)) > 4)
    time.t_step = tic_step (time.t, 4);
  endif
  settings.strips = numel (drawing.strips);
  settings.labels = settings.names = settings.named = settings.places = {};
  settings.curves = settings.low = settings.high = settings.step = {};
  table = drawing.time;
  known = {};
  room = frame_layout (drawing).strip_width;
  for i = 1:settings.strips
    [label, values] = scaled_panel (drawing.strips(i));
    range = padded_range (values);
    settings.labels{i} = label;
    settings.curves{i} = rows (values);
    settings.low{i} = range(1);
    settings.high{i} = range(2);
    settings.step{i} = tic_step (range, 5);
    [names, places, known] = names_of (label, drawing.strips(i).names, room, known);
    settings.named{i} = numel (names);
    settings.names = [settings.names, names];
    settings.places = [settings.places, num2cell(places)];
    table = [table; values];
  endfor
  ## Each frame draws the whole history: no more of it than can be seen.
  time.stride = ceil (columns (table)/4000);
  text = [gnuplot_settings(time), gnuplot_settings(settings), ...
          gnuplot_block("history", {table(:,1:time.stride:end).'})];
endfunction

## one curve is named by the label, and names that a strip above has need not be said again
function [shown, places, known] = names_of (label, names, room, known)
  shown = {};
  places = [];
  if (numel (names) > 1 && ! any (cellfun (@(before) isequal (before, names), known)))
    [shown, places] = strip_names (label, names, room);
    if (numel (shown) == numel (names))
      known{end+1} = names;
    endif
  endif
endfunction

%!test # fine steps are few
%! drawing = sample_drawing (5);
%! drawing.time = 1 + (0:4)*1e-3;
%! step = regexp (strip_data (drawing), 't_step = (\S+)', "tokens"){1}{1};
%! assert (str2double (step) >= 0.001);
%!test # steps of four characters have room, longer ones are fewer
%! for step = [0.05 0.005]
%!   drawing = setfield (sample_drawing (5), "time", (0:4)*step);
%!   assert (! isempty (strfind (strip_data (drawing), sprintf ("t_step = %g", step))) == (step == 0.05));
%! endfor
%!test # names are said once
%! drawing = sample_bodies (3);
%! drawing.strips(2) = setfield (drawing.strips, "label", "again");
%! text = strip_data (drawing);
%! assert (! isempty (strfind (text, "named[2] = [2, 0]")));
%! assert (! isempty (strfind (text, "names[2] = ['x', 'y']")));
%!test # of a long run so many times as can be seen
%! drawing = sample_bodies (2);
%! drawing.time = (0:180000)/50;
%! drawing.strips.values = [drawing.time; -drawing.time];
%! text = strip_data (drawing);
%! history = sscanf (text(strfind (text, "<< END")+6:end), "%f", [3, Inf]);
%! assert (columns (history) <= 4000); assert (history(1,end), 3600, 1);
%! assert (! isempty (strfind (text, "stride = 46")));
%!test # the figures that gnuplot gets, and each time with its values
%! drawing = sample_drawing (5);
%! text = strip_data (drawing);
%! [~, first] = scaled_panel (drawing.strips(1));
%! low = cellfun (@(k) padded_range (nthargout (2, @scaled_panel, drawing.strips(k)))(1), {1, 2, 3});
%! assert (str2num (regexp (text, 'low\[3\] = (\[.*?\])', "tokens", "once"){1}), low, -1e-9);
%! steps = str2num (regexp (text, 'step\[3\] = (\[.*?\])', "tokens", "once"){1});
%! for k = 1:3
%!   [~, values] = scaled_panel (drawing.strips(k));
%!   assert (diff (padded_range (values))/steps(k) <= 5*(1 + 1e-9) && diff (padded_range (values))/steps(k) > 2);
%! endfor
%! history = str2num (regexp (text, '<< END\n(.*?)\nEND', "tokens", "once"){1});
%! assert (history(:,1).', drawing.time, 1e-6);
%! assert (history(:,2:1+rows(first)).', first, 1e-5*max (abs (first(:))));
%! assert (! isempty (regexp (text, "^strips = 3$", "once", "lineanchors")));
%! assert (! isempty (regexp (text, "^stride = 1$", "once", "lineanchors")));
