## -*- texinfo -*-
## @deftypefn {} {@var{text} =} strip_data (@var{drawing})
## The strips beside the frames of @var{drawing} (see @code{draw_pictures}) for @file{strips.gp}: $history, the time and
## all curves, the time's range and step, and what each strip has, as lists of words.
## @end deftypefn

function text = strip_data (drawing)
  time.t = padded_range (drawing.time);
  time.t_step = tic_step (time.t, 6);
  if (numel (sprintf ("%g", time.t_step)) > 4)
    time.t_step = tic_step (time.t, 4);
  endif
  settings = struct ("strips", numel (drawing.strips), "labels", "", "names", "", "named", "", "curves", "", ...
                     "low", "", "high", "", "step", "");
  table = drawing.time;
  for i = 1:settings.strips
    [label, values] = scaled_panel (drawing.strips(i));
    range = padded_range (values);
    settings.labels = [settings.labels, "\"", label, "\" "];
    settings.curves = [settings.curves, sprintf("%d ", rows (values))];
    settings.low = [settings.low, sprintf("%.9g ", range(1))];
    settings.high = [settings.high, sprintf("%.9g ", range(2))];
    settings.step = [settings.step, sprintf("%.9g ", tic_step (range, 5))];
    ## As many names as there is room for, beside the label, in 295 units.
    columns_left = (285 - 8.5*numel (label))/(8.5*max (cellfun (@numel, drawing.strips(i).names)) + 46);
    settings.named = [settings.named, sprintf("%d ", max (0, floor (columns_left)))];
    settings.names = [settings.names, sprintf("\"%s\" ", drawing.strips(i).names{:})];
    table = [table; values];
  endfor
  text = [gnuplot_settings(time), gnuplot_settings(settings), gnuplot_block("history", {table.'})];
endfunction

%!test # fine steps are few
%! drawing = sample_drawing (5);
%! drawing.time = 1 + (0:4)*1e-3;
%! step = regexp (strip_data (drawing), 't_step = (\S+)', "tokens"){1}{1};
%! assert (str2double (step) >= 0.001);
