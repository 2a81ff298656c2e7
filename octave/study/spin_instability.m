## -*- texinfo -*-
## @deftypefn {} {@var{ratio} =} spin_instability (@var{sines})
## The rate of rotation at which the hinged rod of so many bending @var{sines}, without foreshortening, turns unstable,
## over the first frequency omega_1 of the simply supported rod.  The motion of a deflection of a nanometre grows as
## exp (sigma t) there, sigma^2 is linear in the square of the rate, and the line through three such is followed to
## sigma = 0.
## @end deftypefn

function ratio = spin_instability (sines)
  [~, scene] = free_rod ([0 sines], struct ());
  omega = simply_supported_frequency (scene, build_model (scene, rung_of_scene (scene)));
  ratios = [1.1 1.2 1.3];
  for k = 1:numel (ratios)
    rates(k) = growth_rate (sines, ratios(k)*omega)/omega;
  endfor
  ## rate^2 is linear in ratio^2
  line = polyfit (ratios.^2, rates.^2, 1);
  ratio = sqrt (-line(2)/line(1));
endfunction

function rate = growth_rate (sines, phi_dot)
  system = free_rod ([0 sines], struct ("phi_dot", phi_dot, "V2", 1e-9));
  times = linspace (0, 20/phi_dot, 101);
  system.duration = times(end);
  states = integrate (system, times, struct ("name", "waveform", "tolerance", 1e-12));
  late = times > times(end)/2;
  rate = polyfit (times(late), log (abs (states(1,late))), 1)(1);
endfunction

%!assert (spin_instability (5), 1, 0.01)
