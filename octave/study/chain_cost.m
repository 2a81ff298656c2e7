## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} chain_cost (@var{sizes})
## Seconds of integration per simulated second of the scene `chain' with so many rods: rows of [n, seconds, steps].
## @end deftypefn

function rows = chain_cost (sizes)
  rows = zeros (0, 3);
  for n = sizes
    scene = check_mechanism (load_scene (sprintf ("chain(%d)", n)));
    count = run_model (mechanism_kind (), scene, build_mechanism (scene, mechanism_rungs (scene, zeros (1, n)))).count;
    rows(end+1,:) = [n, count.seconds/scene.duration, count.steps];
  endfor
endfunction

%!assert (size (chain_cost (1)), [1 3])
