## -*- texinfo -*-
## @deftypefn {} {@var{jumps} =} find_jumps (@var{load}, @var{t}, @var{values})
## The times (1-by-k, s, increasing) at which a number of a @var{load} (see @code{load_list}) jumps, from its
## @var{values} (numbers-by-m, see @code{load_values}) at the times @var{t} (1-by-m).
##
## Where a number changes faster than beside, its change is bisected to the last bit of t, always into the half with
## more of it: a jump keeps it, whatever is continuous does not.  A jump's time is the first one behind it.  What a
## bisection leaves on both sides of it is looked at again, for jumps near each other.
## @end deftypefn

function jumps = find_jumps (load, t, values)
  jumps = [];
  for number = 1:rows (values)
    x = values(number,:);
    change = abs (diff (x));
    rate = [Inf, change./diff(t), Inf];
    smallest = 1e-9*max (abs (x));
    faster = rate(2:end-1) > 2*min (rate(1:end-2), rate(3:end));
    cell = find (faster & change > smallest);
    from = t(cell);
    to = t(cell+1);
    x_from = x(cell);
    x_to = x(cell+1);
    for depth = 1:8
      if (isempty (from))
        break;
      endif
      [left, right, x_left, x_right] = bisect (load, number, from, to, x_from, x_to);
      found = abs (x_right - x_left) > max (0.01*abs (x_to - x_from), smallest);
      jumps = [jumps, right(found)];
      from = [from(found), right(found)];
      to = [left(found), to(found)];
      x_from = [x_from(found), x_right(found)];
      x_to = [x_left(found), x_to(found)];
      again = abs (x_to - x_from) > smallest & from < to;
      from = from(again);
      to = to(again);
      x_from = x_from(again);
      x_to = x_to(again);
    endfor
  endfor
  jumps = reshape (unique (jumps), 1, []);
endfunction

## many intervals at once, each until no time is between its ends, or until its change is a thousandth
function [a, b, x_a, x_b] = bisect (load, number, a, b, x_a, x_b)
  worth = 1e-3*abs (x_b - x_a);
  for bisection = 1:100
    middle = (a + b)/2;
    going = find (middle > a & middle < b & abs (x_b - x_a) > worth);
    if (isempty (going))
      return;
    endif
    [times, ~, back] = unique (middle(going));
    x = load_values (load, times)(number,back(:).');
    here = abs (x - x_a(going));
    there = abs (x_b(going) - x);
    first = going(here >= there);
    second = going(here < there);
    b(first) = middle(first);
    x_b(first) = x(here >= there);
    a(second) = middle(second);
    x_a(second) = x(here < there);
  endfor
endfunction

%!function jumps = of (f, t, numbers = 1, vectorised = true)
%!  load = load_list ({"moment", f, numbers, "a number", [], vectorised});
%!  jumps = find_jumps (load, t, load_values (load, t));
%!endfunction
%!test # the paper's moment, to the last bit
%! assert (of (@(t) 300*t.*(t < 0.3), linspace (0, 1.8, 1009)), 0.3);
%!test # a pulse of two thousandths of a run that one probe sees, and one that none would
%! assert (of (@(t) 100*(t > 12.3 & t < 12.35), linspace (0, 20, 1009)), [12.3 12.35], 4*eps (12.3));
%!test # neighbours between two probes, and the sum of both
%! assert (of (@(t) (t >= 0.501) + (t >= 0.502), linspace (0, 1, 101)), [0.501 0.502]);
%!test # in the second of two numbers, one t at a time
%! assert (of (@(t) [sin(20*t), t < 0.7], linspace (0, 1, 101), 2, false), 0.7);
%!test # what is continuous does not jump: steep ramps, kinks, fast oscillations, a needle
%! t = linspace (0, 1, 1009);
%! assert (of (@(t) min (max ((t - 0.5)*1e9, 0), 1) + abs (t - 0.2), t), zeros (1, 0));
%! assert (of (@(t) sin (3000*t) + exp (-((t - 0.4)/1e-3).^2), t), zeros (1, 0));
%!test # a thousand samples that are held
%! t = linspace (0, 1, 20011);
%! assert (of (@(t) cos (12.3*floor (500*t)), t), (1:500)/500, 1e-15);
