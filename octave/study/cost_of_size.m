## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} cost_of_size (@var{sizes})
## Seconds of integration per simulated second on the paper's scene with @var{sizes} longitudinal and as many bending
## sines, by `waveform' at 1e-6 m over the first 0.4 s: rows of [N, seconds, calls], medians of three runs.
## @end deftypefn

function rows = cost_of_size (sizes)
  rows = zeros (0, 3);
  for N = sizes
    scene = check_scene (setfield (setfield (load_scene ("paper"), "model", "modes", [N N]), "duration", 0.4));
    system = rod_system (scene, build_model (scene, rung_of_scene (scene)));
    for run = 1:3
      [~, count] = integrate (system, frame_times (scene), struct ("name", "waveform", "tolerance", 1e-6));
      seconds(run) = count.seconds/scene.duration;
    endfor
    rows(end+1,:) = [N, median(seconds), count.calls/scene.duration];
  endfor
endfunction

%!assert (size (cost_of_size ([1 2])), [2 3])
