## -*- texinfo -*-
## @deftypefn {} {[@var{values}, @var{slopes}, @var{seconds}] =} rod_functions (@var{model}, @var{i}, @var{xi}, @
##   @var{length})
## The base functions of the chart's coordinate @var{i} (1 or 2) along a rod of the @var{length} (m), and their first
## and second derivatives, at the stations @var{xi} (p-by-1, m), p-by-n: @var{model}.modes(i) polynomials of Legendre,
## then @var{model}.sines(i) sines sin (k pi xi/length).
## @end deftypefn

function [values, slopes, seconds] = rod_functions (model, i, xi, length)
  [values, slopes, seconds] = legendre_functions (model.modes(i), xi, length);
  k = pi/length*(1:model.sines(i));
  angle = xi(:)*k;
  values = [values, sin(angle)];
  slopes = [slopes, k.*cos(angle)];
  seconds = [seconds, -k.^2.*sin(angle)];
endfunction

%!test # derivatives, by differences
%! model = struct ("modes", [3 4], "sines", [0 2]);
%! [values, slopes, seconds] = rod_functions (model, 2, [0.3; 0.3 + 1e-4; 0.3 - 1e-4], 0.7);
%! assert (columns (values), 6);
%! assert ((values(2,:) - values(3,:))/2e-4, slopes(1,:), 1e-5);
%! assert ((slopes(2,:) - slopes(3,:))/2e-4, seconds(1,:), 1e-4);
