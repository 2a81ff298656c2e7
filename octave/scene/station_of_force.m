## -*- texinfo -*-
## @deftypefn {} {@var{station} =} station_of_force (@var{scene})
## Where the force of a @var{scene} of one rod acts (m): at its force_station, or at the tip where it states none.  One
## that is not on the rod is an error.
## @end deftypefn

function station = station_of_force (scene)
  station = scene.rod.length;
  if (! isempty (scene.force_station))
    station = station_on_rod ("force_station", scene.force_station, scene.rod.length);
  endif
endfunction

%!assert (station_of_force (struct ("rod", struct ("length", 2), "force_station", [])), 2)
%!assert (station_of_force (struct ("rod", struct ("length", 2), "force_station", 0.5)), 0.5)
%!error <force_station is 3: it takes a place on the rod, from 0 to 2 m>
%! station_of_force (struct ("rod", struct ("length", 2), "force_station", 3))
