## -*- texinfo -*-
## @deftypefn {} {} refuse_wrong_rates (@var{rotation}, @var{duration}, @var{what}, @var{names})
## An error where a function @var{rotation} (t) = [theta theta_dot theta_ddot] of a hub, for the @var{duration} (s) of a
## run, has rates that are not those of its angle: at most of 21 times, one of them by more than a thousandth of its
## largest.  It says @var{what} gives that, with the @var{names} of the numbers, and of the first once more.
## @end deftypefn

function refuse_wrong_rates (rotation, duration, what = "rotation", ...
                             names = {"theta", "theta_dot", "theta_ddot", "an angle"})
  t = duration*mod ((1:21)*0.6180339887498949, 0.99) + duration/1000;
  h = 1e-7*duration;
  values = at_times (rotation, t);
  quotients = (at_times (rotation, t + h) - at_times (rotation, t - h))/(2*h);
  for k = 1:2
    rounding = 1e-8*max (abs (values(k,:)))/duration;
    off = abs (quotients(k,:) - values(k+1,:));
    wrong = find (off > 1e-3*max (abs ([quotients(k,:), values(k+1,:)])) + rounding);
    if (numel (wrong) > 10)
      j = wrong(1);
      scene_error (["%s gives %s = %.6g at t = %.6g, where its %s rises by %.6g a second: it takes %s and" ...
                    " its rates"], what, names{k+1}, values(k+1,j), t(j), names{k}, quotients(k,j), ...
                   names{4});
    endif
  endfor
endfunction

%!test # rates of its own, of what rests, turns for long, pushes for a moment, and of what vibrates
%! refuse_wrong_rates (@(t) [0 0 0], 1);
%! refuse_wrong_rates (@(t) [1e4 + 3*t, 3, 0], 1e3);
%! refuse_wrong_rates (@(t) [0.5*max(t - 0.3, 0)^2, max(t - 0.3, 0), t > 0.3], 1);
%! refuse_wrong_rates (@(t) [sin(5e3*t), 5e3*cos(5e3*t), -25e6*sin(5e3*t)], 2);
%!error <rotation gives theta_dot = 0.619034 at t = 0.619034, where its theta rises by 1.23807 a second: it takes an ang>
%! refuse_wrong_rates (@(t) [t^2 t 2], 1);
%!error <joints\(2\).value gives rate = 0.61.* where its value rises by 1.23807 a second: it takes a value and its rates>
%! refuse_wrong_rates (@(t) [t^2 t 2], 1, "joints(2).value", {"value", "rate", "second rate", "a value"});
%!error <rotation gives theta_dot = 0 at t = 0.568256, where its theta rises by 1 a second>  # the first that is wrong
%! refuse_wrong_rates (@(t) [min(t, 1.3), 0, 0], 2.3);
%!error <rotation gives theta_ddot = 0 at t = .*, where its theta_dot rises by 2 a second>
%! refuse_wrong_rates (@(t) [t^2 2*t 0], 3);
