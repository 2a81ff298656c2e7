## -*- texinfo -*-
## @deftypefn {} {@var{system} =} between_breaks (@var{system}, @var{interval}, @var{counted})
## A system (see @code{integrate}) within an @var{interval} (s) between two breaks: its functions of the time take loads
## from inside, since they jump at its ends, and what most return passes through @var{counted} (t, value).
## @end deftypefn

function system = between_breaks (system, interval, counted)
  inside = inside_of (interval);
  within = @(t) min (max (t, inside(1)), inside(2));
  for name = intersect ({"rate", "residual"}, fieldnames (system).')
    of_time = system.(name{1});
    system.(name{1}) = @(t, varargin) counted (t, of_time (within (t), varargin{:}));
  endfor
  for form = intersect ({"momenta", "accelerations"}, fieldnames (system).')
    of_time = system.(form{1}).rate;
    system.(form{1}).rate = @(t, z) counted (t, of_time (within (t), z));
  endfor
  if (isfield (system, "power"))
    power = system.power;
    system.power = @(t, varargin) power (within (t), varargin{:});
  endif
  if (isfield (system, "at"))
    [at, prescribed] = deal (system.at, system.prescribed);
    system.prescribed = @(t) prescribed (within (t));
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
%! system.rate = @(t, y) y + (t < 1);
%! system.residual = @(t, z) 2*z + (t < 1);
%! system.power = @(t, z) 3*z + (t < 1);
%! system.prescribed = @(t) struct ("t", t);
%! system.at = @(t, q, v) t.t;
%! system.momenta.rate = @(t, z) 10*z + (t < 1);
%! system.accelerations.rate = @(t, z) 20*z + (t < 1);
%! twice = @(t, value) 2*value;
%! between = between_breaks (system, [0 1], twice);
%! assert ([between.rate(1, 3), between.residual(1, 3), between.power(1, 3)], [8 14 10]);
%! assert (between.at (1, [], []) < 2); assert (between.at (1, [], []), 2, 1e-12);
%! assert ([between.momenta.rate(1, 3), between.accelerations.rate(1, 3)], [62 122]);
