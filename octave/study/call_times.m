## -*- texinfo -*-
## @deftypefn {} {@var{seconds} =} call_times ()
## Time a call of the rate of the paper's scene at 7 + 7 modes, in the general form and in the literal one, in turn:
## the medians of several runs, [general, literal] in s.  Without a result it prints them and their ratio.
## @end deftypefn

function seconds = call_times ()
  scene = check_scene (load_scene ("paper"));
  scene.model.modes = [7 7];
  rod = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
  y = rod.initial_state + 1e-4;
  general = @() rod.rate (0.1, y);
  literal = @() literal_rod_rate (0.1, y, scene, [7 7]);
  runs = zeros (7, 2);
  for k = 1:rows (runs)
    runs(k,:) = [time_of(general, 1000), time_of(literal, 20)];
  endfor
  times = median (runs);
  if (nargout > 0)
    seconds = times;
  else
    say ("general %.3g s, literal %.3g s a call: %.0f times faster", times, times(2)/times(1));
  endif
endfunction

function seconds = time_of (call, n)
  call ();
  start = tic ();
  for k = 1:n
    call ();
  endfor
  seconds = toc (start)/n;
endfunction

%!assert (size (call_times ()), [1 2])
%!test # what is printed is the ratio of what is printed
%! times = sscanf (evalc ("call_times ();"), "general %g s, literal %g s a call: %g times faster");
%! assert (times(3), times(2)/times(1), -0.1);
