## -*- texinfo -*-
## @deftypefn {} {@var{off} =} methods_agree (@var{duration})
## How far `ode45' at 1e-10 m and `lsode_adams' at 1e-11 m are off `waveform' at 1e-10 m on the paper's scene with 0 +
## 7 sines, tip (m) and hinge angle (rad) over all frames of the @var{duration} (s; the scene's: some 10 minutes), a
## row each.
## @end deftypefn

function off = methods_agree (duration = 1.8)
  scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 7]), "duration", duration));
  model = build_model (scene, rung_of_scene (scene));
  system = rod_system (scene, model);
  times = frame_times (scene);
  states = @(name, tolerance) integrate (system, times, struct ("name", name, "tolerance", tolerance));
  at = @(name, tolerance) measure (system, model, times, states (name, tolerance));
  reference = at ("waveform", 1e-10);
  runs = {"ode45", 1e-10; "lsode_adams", 1e-11};
  for k = 1:2
    found = at (runs{k,:});
    off(k,:) = [norm(hypot (found.tip_x - reference.tip_x, found.tip_y - reference.tip_y), Inf), ...
                norm(found.phi - reference.phi, Inf)];  # NaN where they have one
    printf ("  %-12s %8.2g m %8.2g rad\n", runs{k,1}, off(k,:));
  endfor
endfunction

%!test
%! evalc ("off = methods_agree (0.02);");
%! assert (off < 1e-8);
