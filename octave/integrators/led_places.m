## -*- texinfo -*-
## @deftypefn {} {@var{places} =} led_places (@var{system}, @var{times}, @var{t}, @var{y})
## The places (n-by-k) at the @var{times} (1-by-k, s) after the state @var{y} of a rod on a surface at the time @var{t},
## where another motion leads the @var{system} (see led_by of @code{kind_of}); empty where none does.
## @end deftypefn

function places = led_places (system, times, t, y)
  places = [];
  if (isfield (system, "led"))
    n = system.n;
    places = system.led (times, struct ("t", t, "q", y(1:n), "v", y(n+1:2*n)));
  endif
endfunction

%!assert (led_places (struct ("n", 1), 1, 0, [2; 3]), [])
%!assert (led_places (struct ("n", 1, "led", @(t, y) y.q + y.v*(t - y.t)), [1 3], 1, [2; 3]), [2 8])
