## -*- texinfo -*-
## @deftypefn {} {@var{joules} =} energy_floor (@var{moment_of_inertia}, @var{duration})
## The kinetic energy (J) of a rod with that @var{moment_of_inertia} (kg m^2) about an end which turns by a millionth
## of a radian in the @var{duration} (s): a rod whose energies change by less does not move.
## @end deftypefn

function joules = energy_floor (moment_of_inertia, duration)
  joules = moment_of_inertia*(1e-6/duration)^2/2;
endfunction

%!assert (energy_floor (4e12, 2), 0.5, 1e-15)
