## -*- texinfo -*-
## @deftypefn {} {[@var{frequency}, @var{amplitude}] =} amplitude_spectrum (@var{values}, @var{step})
## The amplitudes (m-by-K) of the oscillations in the rows of @var{values} (m-by-n, every @var{step} s) at the
## frequencies (1-by-K, Hz) from two periods in the whole to half the rate of sampling, by a Hann window; the straight
## line through them is left out.
## @end deftypefn

function [frequency, amplitude] = amplitude_spectrum (values, step)
  n = columns (values);
  values = detrend (values.').';
  window = 1 - cos (2*pi*(0:n-1)/n);
  transformed = abs (fft (values.*window, [], 2))*2/n;
  shown = 3:ceil (n/2);
  frequency = (shown - 1)/(n*step);
  amplitude = transformed(:,shown);
endfunction

%!test # a harmonic oscillation has its amplitude at its frequency, and nothing far from it
%! t = (0:999)*1e-3;
%! [frequency, amplitude] = amplitude_spectrum (0.7*cos (2*pi*40*t + 1) + 5*t, 1e-3);
%! [largest, k] = max (amplitude);
%! assert (frequency(k), 40, 1e-9);
%! assert (largest, 0.7, 0.02);
%! assert (amplitude(abs (frequency - 40) > 3) < 0.01*0.7);
%! assert (frequency([1 end]), [2 499], 1e-9);
