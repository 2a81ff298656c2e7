## -*- texinfo -*-
## @deftypefn {} {@var{lines} =} closing_lines (@var{output}, @var{summary}, @var{names})
## What a person at the terminal wants to know of a run whose files, those of the @var{names} (cellstr) that it made,
## are in the folder of @var{output} (see @code{take_options}): a cellstr of at most 12 lines.
## @end deftypefn

function lines = closing_lines (output, summary, names)
  lines = {summary.title, sprintf("model: %s (%s)", summary.model, summary.model_reason)};
  if (! isempty (summary.estimated_error_m))
    lines{end+1} = sprintf ("estimated error: %.2g m, %.2g pixels", summary.estimated_error_m, ...
                            summary.estimated_error_pixels);
  endif
  steps = "";  # which Octave's codes do not tell
  if (! isnan (summary.steps))
    steps = sprintf ("%d steps, ", summary.steps);
  endif
  lines{end+1} = sprintf ("%s, tolerance %.2g m: %s%d calls, energy balance within %.1g", summary.method, ...
                          summary.tolerance_m, steps, summary.rate_calls, summary.largest_energy_error);
  lines{end+1} = sprintf ("seconds: %.1f choice of the model, %.1f integration, %.1f pictures, %.1f in all", ...
                          summary.seconds.choice, summary.seconds.integration, summary.seconds.pictures, ...
                          summary.seconds.total);
  warnings = strcat ({"warning: "}, summary.warnings(1:min (end, 5)));
  left_out = numel (summary.warnings) - numel (warnings);
  if (left_out > 0)
    warnings{end+1} = sprintf ("warning: %d more in summary.json", left_out);
  endif
  last = sprintf ("%s/ has %s", output.folder, strjoin (names, ", "));
  if (! output.pictures)
    last = [last " (PICTURES=no: numbers alone)"];
  endif
  lines = [lines, warnings(:).', {last}];
endfunction

%!test # twelve lines, however much there is to say
%! seconds = struct ("choice", 0, "integration", 1, "pictures", 2, "total", 3);
%! summary = struct ("title", "A rod", "model", "rigid", "model_reason", "given", "estimated_error_m", 1e-6, ...
%!                   "estimated_error_pixels", 0.1, "method", "rk4", "tolerance_m", 1e-5, "steps", 3, ...
%!                   "rate_calls", 12, "largest_energy_error", 1e-9, "seconds", seconds, ...
%!                   "warnings", {repmat({"look"}, 1, 9)});
%! output = struct ("folder", "out", "pictures", true);
%! lines = closing_lines (output, summary, {"history.csv", "frames"});
%! assert (numel (lines), 12);
%! assert (lines{11}, "warning: 4 more in summary.json");
%! assert (lines{12}, "out/ has history.csv, frames");
%! summary.warnings = repmat ({"look"}, 1, 6);
%! assert (closing_lines (output, summary, {}){11}, "warning: 1 more in summary.json");
%! lines = closing_lines (output, setfield (summary, "steps", NaN), {});
%! assert (lines{4}, "rk4, tolerance 1e-05 m: 12 calls, energy balance within 1e-09");
%! output.pictures = false;
%! assert (closing_lines (output, summary, {"history.csv"}){12}, "out/ has history.csv (PICTURES=no: numbers alone)");
