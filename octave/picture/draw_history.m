## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_history (@var{drawing}, @var{scratch})
## The time histories of @var{drawing} (see @code{draw_pictures}), @file{history.svg} beside the folder @var{scratch},
## which takes the data, with the spectrum at the foot where the drawing has one. It is there when @var{job} has ended
## (see @code{finish_tool}).
## @end deftypefn

function job = draw_history (drawing, scratch)
  panels = drawing.panels;
  time = panel_time (drawing);
  shown = 1:ceil (numel (time)/20000):numel (time);  # more would be a file that no browser opens
  settings = scene_settings (drawing, fit_camera (drawing, [1 1]));
  settings.t = padded_range (drawing.time);
  settings.panels = numel (panels);
  settings.dots = double (isequal (time, drawing.time));  # a frame each
  inside = drawing.moment_breaks > drawing.time(1) & drawing.moment_breaks < drawing.time(end);
  settings.break_count = sum (inside);
  settings.breaks = num2cell (drawing.moment_breaks(inside));
  settings.spectrum = double (! isempty (field_or (drawing, "spectrum", [])));
  names = [{""}, panels.names];
  if (any (inside))
    names{end+1} = "break of loads";
  endif
  if (settings.spectrum)
    names{end+1} = "predicted, at rest";
    write_text (fullfile (scratch, "spectrum.gp"), spectrum_data (drawing.spectrum));
  endif
  settings.longest_name = max (cellfun (@numel, names));
  write_text (fullfile (scratch, "settings.gp"), gnuplot_settings (settings));
  for i = 1:numel (panels)
    [label, values] = scaled_panel (panels(i));
    panel = struct ("label", label, "names", {panels(i).names}, ...
                    "range", padded_range (values), "step", tic_step (padded_range (values), 5));
    write_text (fullfile (scratch, sprintf ("panel_%d.gp", i)),
                [gnuplot_settings(panel), gnuplot_block("curves", {[time(shown); values(:,shown)].'})]);
  endfor
  job = start_gnuplot (scratch, "history.gp");
endfunction

## Five decades are shown; what predicted frequencies there are, stands as words.
function text = spectrum_data (spectrum)
  [label, values] = scaled_panel (spectrum);
  high = 10^ceil (log10 (max ([values(:); realmin])));
  settings = struct ("spectrum_label", label, "note", spectrum.note, "spectrum_names", {spectrum.names}, ...
                     "predicted_count", numel (spectrum.predicted), "predicted", {num2cell(spectrum.predicted)}, ...
                     "frequency", spectrum.frequency([1, end]), "amplitude", [1e-5*high, high], ...
                     "frequency_tics", {num2cell(decade_tics (spectrum.frequency([1, end])))});
  text = [gnuplot_settings(settings), gnuplot_block("spectrum", {[spectrum.frequency; values].'})];
endfunction

## 1, 2, 5, 10, ..., or powers of ten alone where those are many
function tics = decade_tics (range)
  decades = floor (log10 (range(1))):ceil (log10 (range(2)));
  digits = 1;
  if (diff (log10 (range)) < 2.5)
    digits = [1, 2, 5];
  endif
  tics = (digits.'.*10.^decades)(:).';
  tics = tics(tics >= 0.999*range(1) & tics <= 1.001*range(2));
endfunction

%!function text = drawn (drawing, folder, scratch)
%!  finish_tool (draw_history (drawing, scratch));
%!  text = fileread (fullfile (folder, "history.svg"));
%!endfunction
%!function text = history_of (drawing)
%!  text = in_scratch (@(folder, scratch) drawn (drawing, folder, scratch));
%!endfunction

%!function files = files_of (drawing, scratch)   # what is written for gnuplot
%!  finish_tool (draw_history (drawing, scratch));
%!  files = struct ();
%!  for name = {"settings", "spectrum", "panel_1"}
%!    if (exist (fullfile (scratch, [name{1} ".gp"]), "file"))
%!      files.(name{1}) = fileread (fullfile (scratch, [name{1} ".gp"]));
%!    endif
%!  endfor
%!endfunction
%!function hold_lines (text, lines)
%!  for line = lines
%!    assert (numel (strfind (["\n" text], ["\n" line{1} "\n"])) == 1, "%s", line{1});
%!  endfor
%!endfunction
%!test # the figures that gnuplot gets: breaks within the time, the longest name, five decades, tics of a spectrum
%! drawing = sample_drawing (20);
%! drawing.moment_breaks = [drawing.time(1), 0.1, 0.3, drawing.time(end), 99];
%! files = in_scratch (@(folder, scratch) files_of (drawing, scratch));
%! hold_lines (files.settings, {"break_count = 2", "array breaks[2] = [0.1, 0.3]", "spectrum = 0", "panels = 5", ...
%!                              "longest_name = 14"});
%! hold_lines (files.panel_1, {sprintf("label = '%s'", scaled_panel (drawing.panels(1)))});
%! data = str2num (regexp (files.panel_1, '<< END\n(.*?)\nEND', "tokens", "once"){1});
%! assert (data(:,1).', drawing.time, 1e-6);
%! assert (data(:,2:end).', nthargout (2, @scaled_panel, drawing.panels(1)), -1e-6);
%! drawing.spectrum = struct ("label", "spectrum of the tip", "unit", "m", "names", {{"tip"}}, "frequency", 1:50, ...
%!                            "values", 2e-3./(1:50), "predicted", [7 30], "note", "sampled at 100 Hz");
%! files = in_scratch (@(folder, scratch) files_of (drawing, scratch));
%! hold_lines (files.settings, {"spectrum = 1", "longest_name = 18"});
%! hold_lines (files.spectrum, {"predicted_count = 2", "array predicted[2] = [7, 30]", "frequency_low = 1", ...
%!   "frequency_high = 50", "amplitude_low = 0.0001", "amplitude_high = 10", ...
%!   "array frequency_tics[6] = [1, 2, 5, 10, 20, 50]"});
%! drawing.spectrum.frequency = 10*(1:50);
%! drawing.spectrum.frequency(end) = 1e4;
%! files = in_scratch (@(folder, scratch) files_of (drawing, scratch));
%! hold_lines (files.spectrum, {"array frequency_tics[4] = [10, 100, 1000, 10000]"});
%!test
%! text = history_of (sample_drawing (20));
%! for shown = {"energies, J", "V2_1", "largest modes, µm", "break of loads", "ψ"}
%!   assert (! isempty (strfind (text, shown{1})), shown{1});
%! endfor
%!test # a spectrum
%! drawing = sample_drawing (20);
%! drawing.spectrum = struct ("label", "spectrum of the tip", "unit", "m", "names", {{"tip"}}, "frequency", 1:50, ...
%!                            "values", 1e-3./(1:50), "predicted", [7 30], "note", "sampled at 100 Hz");
%! text = history_of (drawing);
%! for shown = {"spectrum of the tip, mm", "frequency, Hz (sampled at 100 Hz)"}
%!   assert (! isempty (strfind (text, shown{1})), shown{1});
%! endfor
%!test # a single frame, and a break that is not in the picture
%! assert (isempty (strfind (history_of (sample_drawing (1)), "break of loads")));
