## -*- texinfo -*-
## @deftypefn {} {@var{system} =} between_breaks (@var{system}, @var{interval}, @var{counted})
## A system (see @code{integrate}) within an @var{interval} (s) between two breaks: its functions take loads from
## inside, and what they return passes through @var{counted} (t, value).
## @end deftypefn

function system = between_breaks (system, interval, counted)
  inside = inside_of (interval);
  if (isfield (system, "rate"))
    rate = system.rate;
    system.rate = @(t, y) counted (t, rate (t, y, inside));
  endif
  for form = intersect ({"momenta", "accelerations"}, fieldnames (system).')
    form_rate = system.(form{1}).rate;
    system.(form{1}).rate = @(t, z) counted (t, form_rate (t, z, inside));
  endfor
  if (isfield (system, "residual"))
    residual = system.residual;
    system.residual = @(t, varargin) counted (t, residual (t, varargin{:}));
  endif
  if (isfield (system, "at"))
    [at, prescribed] = deal (system.at, system.prescribed);
    system.prescribed = @(t) prescribed (min (max (t, inside(1)), inside(2)));
    system.at = @(t, q, v) at (t_counted (t, system.prescribed, counted), q, v);
  endif
endfunction

## the values that are prescribed, where they are not known yet
function t = t_counted (t, prescribed, counted)
  if (isnumeric (t))
    t = prescribed (t);
  endif
  t.t = counted (t.t, t.t);
endfunction

%!test
%! system.rate = @(t, y, interval) y + (interval(2) < 1);
%! system.prescribed = @(t) struct ("t", t);
%! system.at = @(t, q, v) t.t;
%! system.momenta.rate = @(t, z, interval) 10*z + (interval(2) < 1);
%! system.accelerations.rate = @(t, z, interval) 20*z + (interval(2) < 1);
%! twice = @(t, value) 2*value;
%! between = between_breaks (system, [0 1], twice);
%! assert (between.rate (1, 3), 8);
%! assert (between.at (1, [], []) < 2); assert (between.at (1, [], []), 2, 1e-12);
%! assert ([between.momenta.rate(1, 3), between.accelerations.rate(1, 3)], [62 122]);
