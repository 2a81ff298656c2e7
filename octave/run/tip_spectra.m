## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} tip_spectra (@var{deflection}, @var{step}, @var{predicted})
## The amplitude spectra of a tip's @var{deflection} along and across the tangent at its rod's start (2-by-m, m, every
## @var{step} s): a struct of @code{label}, @code{unit}, @code{names}, @code{frequency} (1-by-K, Hz), @code{values}
## (2-by-K, m; see @code{amplitude_spectrum}), @code{predicted} (1-by-n, Hz: those of the @var{predicted} frequencies
## that are seen), and @code{note}, a text that says how it was sampled.
## @end deftypefn

function spectrum = tip_spectra (deflection, step, predicted = [])
  [frequency, values] = amplitude_spectrum (deflection, step);
  highest = 1/(2*step);
  predicted = sort (predicted(predicted > 1e-6*max ([predicted, 1])));
  seen = predicted < highest;
  spectrum = struct ("label", "spectra of the tip from tangent", "unit", "m", "names", {{"along", "across"}}, ...
                     "frequency", frequency, "values", values, "predicted", predicted(seen));
  spectrum.note = ["sampled at " in_hertz(2*highest)];
  if (! all (seen))
    spectrum.note = sprintf ("%s; %d predicted ones lie beyond %s", spectrum.note, sum (! seen), in_hertz (highest));
  endif
endfunction

function text = in_hertz (frequency)
  [scale, unit] = unit_prefix (frequency, "Hz");
  text = sprintf ("%.4g %s", frequency/scale, unit);
endfunction

%!test # an oscillation has its amplitude, and what is too fast is told
%! t = (0:999)*1e-3;
%! spectrum = tip_spectra ([0.1*cos(2*pi*50*t); 0*t], 1e-3, [50 2000 0]);
%! [largest, k] = max (spectrum.values(1,:));
%! assert (largest, 0.1, 1e-3); assert (spectrum.frequency(k), 50, 1e-9); assert (spectrum.predicted, 50);
%! assert (spectrum.note, "sampled at 1 kHz; 1 predicted ones lie beyond 500 Hz");
