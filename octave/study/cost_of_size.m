## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} cost_of_size (@var{kind}, @var{scene}, @var{sizes})
## Seconds of integration per simulated second of a checked scene of a @var{kind} (see @code{kind_of}) with so many modes
## of each sort (see sized there), by the solver "auto" over the first quarter of the duration: rows of [n, seconds, calls],
## medians of three runs.  Sizes that the kind has not, and those after one that took 20 s, are left out.
## @end deftypefn

function rows = cost_of_size (kind, scene, sizes)
  rows = zeros (0, 3);
  times = frame_times (scene);
  times = times(1:ceil (end/4)+1);
  solver = setfield (scene.solver, "name", "auto");
  for n = sizes
    model = kind.sized (scene, n);
    if (isempty (model))
      continue;
    endif
    system = kind.system (scene, model);
    seconds = [];
    do
      [~, count] = integrate (system, times, solver);
      seconds(end+1) = count.seconds/times(end);
    until (numel (seconds) == 3 || count.seconds > 5)
    rows(end+1,:) = [n, median(seconds), count.calls/times(end)];
    if (count.seconds > 20)
      break;
    endif
  endfor
endfunction

%!test
%! scene = check_scene (setfield (paper (), "duration", 0.1));
%! rows = cost_of_size (rod_kind (), scene, [1 2]);
%! assert (rows(:,1), [1; 2]); assert (size (rows), [2 3]);
%!test # fewer than four polynomials lock
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.04));
%! assert (cost_of_size (surface_kind (), scene, [2 4])(:,1), 4);
%!test # bodies that state their modes have other numbers of them here
%! scene = check_mechanism (setfield (setfield (chain (1), "duration", 0.2), "frames_per_second", 20));
%! rows = cost_of_size (mechanism_kind (), scene, [1 4]);
%! assert (rows(2,3) > rows(1,3));
%!function rows = with_clock (sizes, seconds)   # of so many seconds and of calls for a quarter of 4 s
%!  body = sprintf ("states = []; count = struct ('seconds', %g, 'calls', 3*times(end)^2);", seconds);
%!  stand_ins = {"[states, count] = integrate", "system, times, solver", body};
%!  kind = struct ("sized", @(scene, n) n(n != 2), "system", @(scene, model) model);
%!  scene = struct ("duration", 4, "frames_per_second", 25, "solver", struct ("name", "rk4"));
%!  with_stand_ins (stand_ins, @() setenv ("ROWS_OF_COST", mat2str (cost_of_size (kind, scene, sizes), 17)));
%!  rows = eval (getenv ("ROWS_OF_COST"));
%!endfunction
%!test # sizes that there are not are left out, and those after one that took 20 s
%! rows = with_clock ([1 2 4], 5);
%! assert (rows(:,1), [1; 4]); assert (rows(:,2:3), [5/1.04 3*1.04; 5/1.04 3*1.04], 1e-12);
%! assert (with_clock ([1 2 4], 21)(:,1), 1); assert (with_clock ([1 2 4], 20)(:,1), [1; 4]);
