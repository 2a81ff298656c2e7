## -*- texinfo -*-
## @deftypefn {} {@var{wall} =} step_wall (@var{method}, @var{tolerances})
## The mean step times the highest frequency that the adaptive explicit @var{method} takes on the paper's rod with 7 +
## 7 modes at @var{tolerances} (m), rows of [tolerance, h*omega, largest error of a coordinate in m].
## It cannot pass the limit of stability, however loose the tolerance.
## @end deftypefn

function wall = step_wall (method, tolerances)
  [system, scene] = free_rod ([7 7], struct ("phi_dot", 5, "V2", 1e-3));
  times = [0 0.01];
  reference = integrate (system, times, struct ("name", "waveform", "tolerance", 1e-9));
  omega = highest_frequency (system);
  wall = zeros (0, 3);
  for tolerance = tolerances
    [states, count] = integrate (system, times, struct ("name", method, "tolerance", tolerance));
    n = rows (system.mass);
    wall(end+1,:) = [tolerance, times(2)/count.steps*omega, max(abs (states - reference)(1:n,2))];
  endfor
endfunction

%!test # the loosest tolerance ends at the wall
%! wall = step_wall ("ode23", [1 0.1]);
%! assert (wall(1,2) < 1.05*stability_limit ("ode23"));
%! assert (wall(1,2) > 0.8*stability_limit ("ode23"));
