## -*- texinfo -*-
## @deftypefn {} {@var{values} =} load_values (@var{load}, @var{times})
## The numbers of a @var{load} (see @code{load_list}) at the @var{times} (1-by-m, s, increasing), numbers-by-m.
##
## A load that fails at one of them, or does not give so many finite real numbers, is an error that names it, the time
## and what it takes.  The time is the first one: it is bisected from the last of the times at which the load is good.
## @end deftypefn

function values = load_values (load, times)
  [values, good] = all_at_once (load, times);
  if (good)
    return;
  endif
  values = zeros (load.numbers, numel (times));
  for k = 1:numel (times)
    [value, fault] = value_at (load, times(k));
    if (! isempty (fault))
      refuse (load, times(max (k - 1, 1)), times(k));
    endif
    values(:,k) = value;
  endfor
  if (load.vectorised)
    refuse_vectors (load, times(unique (round (linspace (1, end, 3)))));
  endif
endfunction

function [values, good] = all_at_once (load, times)
  values = [];
  good = false;
  try
    if (load.vectorised)
      values = load.at (times);
    else
      values = at_times (load.at, times);
    endif
    good = isnumeric (values) && isreal (values) && isequal (size (values), [load.numbers, numel(times)]) ...
           && all (isfinite (values)(:));
  end_try_catch
endfunction

## value: numbers-by-1; fault: what is wrong with it, or empty
function [value, fault] = value_at (load, t)
  value = fault = [];
  try
    value = load.at (t);
  catch err
    fault = sprintf ("fails at t = %.9g: %s", t, placed_message (err));
    return;
  end_try_catch
  if (! (isnumeric (value) && isreal (value) && numel (value) == load.numbers && all (isfinite (value(:)))))
    fault = sprintf ("gives %s at t = %.9g: it takes %s", text_of (value), t, load.takes);
  endif
  value = value(:);
endfunction

## the first time after `good' at which the load is bad, as it is at `bad'
function refuse (load, good, bad)
  for bisection = 1:100
    middle = (good + bad)/2;
    if (middle <= good || middle >= bad)
      break;
    endif
    [~, fault] = value_at (load, middle);
    if (isempty (fault))
      good = middle;
    else
      bad = middle;
    endif
  endfor
  [~, fault] = value_at (load, bad);
  scene_error ("%s %s", load.name, fault);
endfunction

## good at each time, but not at several
function refuse_vectors (load, times)
  try
    values = load.at (times);
  catch err
    scene_error ("%s fails at t = [%s]: %s: it takes %s", load.name, num2str (times), placed_message (err), ...
                 load.takes);
  end_try_catch
  scene_error ("%s gives %s at t = [%s]: it takes %s", load.name, text_of (values), num2str (times), load.takes);
endfunction

function text = text_of (value)
  text = sprintf ("a %s %s", strrep (num2str (size (value)), "  ", "-by-"), class (value));
  if ((isnumeric (value) || islogical (value)) && numel (value) <= 9)
    text = mat2str (value);
  endif
endfunction

%!function load = of (f, numbers = 1, vectorised = false)
%!  load = load_list ({"joints(2).value", f, numbers, "two numbers, F_x and F_y in N", [], vectorised});
%!endfunction
%!assert (load_values (of (@(t) [t 2*t], 2), [1 2]), [1 2; 2 4])
%!assert (load_values (of (@(t) 300*t, 1, true), [1 2]), [300 600])
%!error <joints\(2\).value gives \[NaN 1\] at t = 0.6: it takes two numbers, F_x and F_y in N>
%! load_values (of (@(t) [t/(t < 0.6 || t > 0.8) - t/(t < 0.6 || t > 0.8), 1], 2), 0:0.03:1);
%!function value = no_wind (t)
%!  value = 1;
%!  if (t >= 0.7)
%!    error ("no wind");
%!  endif
%!endfunction
%!error <joints\(2\).value fails at t = 0.7: no wind> load_values (of (@no_wind), 0:0.2:1);
%!error <joints\(2\).value gives .*i at t = 0.25: it takes> load_values (of (@(t) sqrt (0.25 - t), 1, true), 0:0.2:1);
%!error <joints\(2\).value gives \[1 2\] at t = 0.5> load_values (of (@(t) 1:1+(t >= 0.5)), 0:0.2:1);
%!error <joints\(2\).value gives 1 at t = 1: it takes two> load_values (of (@(t) 1:1+2*(t < 1), 2), [1 2])
%!error <joints\(2\).value gives 300 at t = \[0  1\]: it takes two> load_values (of (@(t) 300, 1, true), [0 1])
%!error <joints\(2\).value fails at t = \[0  1\]: .*nonconformant.*: it takes two>
%! load_values (of (@(t) t*t, 1, true), [0 1])
