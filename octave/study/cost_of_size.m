## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} cost_of_size (@var{kind}, @var{scene}, @var{sizes}, @var{limit})
## Seconds of integration per simulated second of a checked scene of a @var{kind} (see @code{kind_of}) with so many
## modes of each sort (see sized there), by the solver "auto" over the first quarter of the duration: rows of [n,
## seconds, calls], medians of three runs where they are short.  Sizes that the kind has not, and those for which the
## @var{limit} (s) leaves no time, are left out.
## @end deftypefn

function rows = cost_of_size (kind, scene, sizes, limit)
  rows = zeros (0, 3);
  times = frame_times (scene);
  times = times(1:ceil (end/4)+1);
  solver = setfield (scene.solver, "name", "auto");
  clock = tic ();
  for n = sizes
    model = kind.sized (scene, n);
    if (isempty (model))
      continue;
    endif
    solver.seconds = limit - toc (clock);
    try
      rows(end+1,:) = [n, measured(kind.system (scene, model), times, solver)];
    catch err
      rethrow_others (err, "toolchain:integration");
      break;
    end_try_catch
  endfor
endfunction

## seconds and calls a simulated second
function pair = measured (system, times, solver)
  seconds = [];
  do
    [~, count] = integrate (system, times, solver);
    seconds(end+1) = count.seconds;
  until (numel (seconds) == 3 || sum (seconds) > solver.seconds/10)
  pair = [median(seconds), count.calls]/times(end);
endfunction

%!test
%! scene = check_scene (setfield (paper (), "duration", 0.1));
%! rows = cost_of_size (rod_kind (), scene, [1 2], 60);
%! assert (rows(:,1), [1; 2]); assert (size (rows), [2 3]);
%!test # fewer than four polynomials lock
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.04));
%! assert (cost_of_size (surface_kind (), scene, [2 4], 60)(:,1), 4);
%!test # bodies that state their modes have other numbers of them here
%! scene = check_mechanism (setfield (setfield (chain (1), "duration", 0.2), "frames_per_second", 20));
%! rows = cost_of_size (mechanism_kind (), scene, [1 4], 60);
%! assert (rows(2,3) > rows(1,3));
%!test # no time, no row
%! scene = check_scene (setfield (paper (), "duration", 0.1));
%! assert (cost_of_size (rod_kind (), scene, [1 2], 0), zeros (0, 3));
