## -*- texinfo -*-
## @deftypefn {} {@var{station} =} station_on_rod (@var{what}, @var{station}, @var{length}, @var{where})
## A @var{station} (m) of a rod of the @var{length} (m): its end where it is off that by no more than rounding.  One
## beyond the rod is an error, which says @var{what} it is and @var{where} it takes a place, by default on the rod.
## @end deftypefn

function station = station_on_rod (what, station, length, where = "the rod")
  ends = [0, length];
  near = abs (station - ends) < 1e-9*length;
  if (any (near))
    station = ends(near);
  elseif (station < 0 || station > length)
    scene_error ("%s is %g: it takes a place on %s, from 0 to %g m", what, station, where, length);
  endif
endfunction

%!test # but for rounding
%! assert (station_on_rod ("force_station", 0.3 - 0.1*3, 0.3), 0);
%! assert (station_on_rod ("force_station", 0.1*3 - 0.3, 0.3), 0);
%! assert (station_on_rod ("force_station", 0.1*3, 0.3), 0.3); assert (station_on_rod ("force_station", 0.2, 0.3), 0.2);
%!error <force_station is 3: it takes a place on the rod, from 0 to 2 m> station_on_rod ("force_station", 3, 2)
%!error <stations\(2\) is -1: it takes a place on body 3, from 0 to 2 m> station_on_rod ("stations(2)", -1, 2, "body 3")
