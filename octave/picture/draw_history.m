## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_history (@var{drawing}, @var{scratch})
## The time histories of @var{drawing} (see @code{draw_pictures}), @file{history.svg} beside the folder @var{scratch},
## which takes the data, with the spectrum at the foot where the drawing has one. It is there when @var{job} has ended
## (see @code{finish_tool}).
## @end deftypefn

function job = draw_history (drawing, scratch)
  panels = drawing.panels;
  frames = numel (drawing.time);
  shown = 1:ceil (frames/20000):frames;  # more would be a file that no browser opens
  settings = scene_settings (drawing, fit_camera (drawing, [1 1]));
  settings.t = padded_range (drawing.time);
  settings.panels = numel (panels);
  inside = drawing.moment_breaks > drawing.time(1) & drawing.moment_breaks < drawing.time(end);
  settings.break_count = sum (inside);
  settings.breaks = num2cell (drawing.moment_breaks(inside));
  settings.spectrum = double (isfield (drawing, "spectrum") && ! isempty (drawing.spectrum));
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
                [gnuplot_settings(panel), gnuplot_block("curves", {[drawing.time(shown); values(:,shown)].'})]);
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
