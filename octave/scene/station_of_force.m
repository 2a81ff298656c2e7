## -*- texinfo -*-
## @deftypefn {} {@var{station} =} station_of_force (@var{scene})
## Where the force of a @var{scene} of one rod acts (m): at its force_station, or at the tip where it states none.  One
## beyond the rod is an error.
## @end deftypefn

function station = station_of_force (scene)
  station = scene.force_station;
  if (isempty (station))
    station = scene.rod.length;
  elseif (station > scene.rod.length)
    scene_error ("force_station is %g: it takes a place on the rod, at most %g m", station, scene.rod.length);
  endif
endfunction

%!assert (station_of_force (struct ("rod", struct ("length", 2), "force_station", [])), 2)
%!assert (station_of_force (struct ("rod", struct ("length", 2), "force_station", 0.5)), 0.5)
%!error <force_station is 3: it takes a place on the rod, at most 2 m>
%! station_of_force (struct ("rod", struct ("length", 2), "force_station", 3))
