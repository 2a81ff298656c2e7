## -*- texinfo -*-
## @deftypefn {} {@var{ends} =} find_rests (@var{load}, @var{t}, @var{values})
## The times (1-by-k, s, increasing) at which a @var{load} (see @code{load_list}) that stays as it is for a hundredth
## of the run or longer begins to change, or comes to such a rest, from its @var{values} (numbers-by-m) at the times
## @var{t} (1-by-m): where a blow that does not jump begins and ends, which steps grown long in the rest would pass.
##
## They are bisected to the last bit of t.  At rest is what changes by less than 1e-9 of the largest value, or, where
## it does not change at all, the least change ends the rest.
## @end deftypefn

function ends = find_rests (load, t, values)
  longest = ceil (numel (t)/100);
  ends = zeros (1, 0);
  for number = setdiff (1:rows (values), load.prescribed)  # what is prescribed follows its acceleration
    x = values(number,:);
    tolerance = 1e-9*max (abs (x));
    still = [false, abs(diff (x)) <= tolerance, false];
    first = find (diff (still) == 1);
    last = find (diff (still) == -1);
    long = last - first >= longest;
    for k = find (long)
      value = x(round ((first(k) + last(k))/2));
      allowed = tolerance*any (x(first(k):last(k)) != value);
      rests = @(time) abs (load_values (load, time)(number) - value) <= allowed;
      if (first(k) > 1 && ! rests (t(first(k)-1)))
        ends(end+1) = bisect (rests, t(first(k)), t(first(k)-1));
      endif
      if (last(k) < numel (t) && ! rests (t(last(k)+1)))
        ends(end+1) = bisect (rests, t(last(k)), t(last(k)+1));
      endif
    endfor
  endfor
  ends = reshape (unique (ends), 1, []);
endfunction

function time = bisect (rests, time, beyond)
  for bisection = 1:100
    middle = (time + beyond)/2;
    if (middle == time || middle == beyond)
      break;
    elseif (rests (middle))
      time = middle;
    else
      beyond = middle;
    endif
  endfor
endfunction

%!function ends = of (f)
%!  load = load_list ({"moment", f, 1, "a number", [], true});
%!  t = linspace (0, 20, 4001);
%!  ends = find_rests (load, t, load_values (load, t));
%!endfunction
%!test # half a sine in a long rest
%! ends = of (@(t) 100*sin (pi*(t - 12.3)/0.05).*(t > 12.3 & t < 12.35));
%! assert (ends, [12.3 12.35], 4*eps (12.3));
%!test # between the times at which it is given
%! ends = of (@(t) 100*sin (pi*(t - 12.3012)/0.05).*(t > 12.3012 & t < 12.3512));
%! assert (ends, [12.3012 12.3512], 4*eps (12.3));
%!test # a ramp to a value that stays
%! assert (of (@(t) 5 - 2*min (t/3, 1)), 3, 1e-14);
%! assert (of (@(t) 5 - 2*min (t/3.0012, 1)), 3.0012, 1e-8);
%!test # the tails of a bell curve, where they are a billionth of it
%! width = 0.02;
%! assert (of (@(t) 7*exp (-((t - 8)/width).^2)), 8 + [-1 1]*width*sqrt (log (1e9)), 1e-5);
%!assert (of (@(t) sin (t)), zeros (1, 0))
%!assert (of (@(t) 3 + 0*t), zeros (1, 0))
