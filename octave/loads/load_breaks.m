## -*- texinfo -*-
## @deftypefn {} {[@var{breaks}, @var{probed}] =} load_breaks (@var{loads}, @var{stated}, @var{scene})
## The times (1-by-k, s, within the run) that no step of an integration may run across: those @var{stated}, and those
## at which one of the @var{loads} (see @code{load_list}) jumps, or begins or ends to change (see @code{find_jumps} and
## @code{find_rests}).  A load that is bad at a time that was looked at is an error (see @code{load_values}), and so is
## a jump of a prescribed place or of its rate, which no force makes.
##
## Each load is looked at at 20011 equally spaced times of the run where it takes vectors, else at 4001, or, where that
## would take more than two seconds of the processor, at 1009; and at the frames, unless they are more.  A pulse
## between two of these times is not seen.  Kinks of a load that changes before and after are left to the steps.
##
## @var{probed}, a struct array: name of a load, looked_at (how often), breaks (those found and not stated, s).  More
## than 1000 jumps of a load are not taken.
## @end deftypefn

function [breaks, probed] = load_breaks (loads, stated, scene)
  breaks = reshape (unique (stated), 1, []);
  breaks(diff (breaks) <= 1e-12*scene.duration) = [];
  probed = struct ("name", {}, "looked_at", {}, "breaks", {});
  for load = loads
    load_values (load, [0, 0.5, 1]*scene.duration);
    t = probe_times (load, scene.duration);
    values = load_values (load, t);
    frames = frame_times (scene);
    if (numel (frames) <= numel (t))
      load_values (load, frames);
    endif
    jumps = find_jumps (load, t, values);
    refuse_prescribed (load, jumps);
    if (numel (jumps) > 1000)
      jumps = [];
    endif
    found = [jumps, without_tails(load, find_rests (load, t, values), [breaks, jumps], values, scene.duration)];
    found = found(found > 1e-12*scene.duration & found < scene.duration*(1 - 1e-12));
    [breaks, new] = united (breaks, found, scene.duration);
    probed(end+1) = struct ("name", load.name, "looked_at", numel (t), "breaks", new);
  endfor
  breaks = breaks(breaks > 0 & breaks < scene.duration);
endfunction

## the ends of rests at which a load fades to a break: as far beyond the end as the break is, it is a millionth yet
function ends = without_tails (load, ends, breaks, values, duration)
  size_of = max (abs (values), [], 2);
  is_tail = false (size (ends));
  for k = 1:numel (ends)
    near = reshape (breaks(abs (breaks - ends(k)) <= duration/100), 1, []);
    beyond = load_values (load, min (max (2*ends(k) - near, 0), duration));
    is_tail(k) = any (all (abs (beyond - load_values (load, ends(k))) <= 1e-6*size_of, 1));
  endfor
  ends = ends(! is_tail);
endfunction

function t = probe_times (load, duration)
  count = 4001;
  if (load.vectorised)
    count = 20011;
  endif
  few = linspace (0, duration, 41);
  start = cputime ();  # which other work on the machine leaves alone
  load_values (load, few);
  if ((cputime () - start)*count/41 > 2)
    count = 1009;
  endif
  t = linspace (0, duration, count);
endfunction

## a jump that is known to a few bits is that jump; one that is stated roughly is where it was found
function [breaks, new] = united (breaks, found, duration)
  new = zeros (1, 0);
  for time = found
    off = abs (breaks - time);
    if (! any (off <= 4*eps (time)))
      breaks(off <= 1e-9*duration) = [];
      breaks = sort ([breaks, time]);
      new(end+1) = time;
    endif
  endfor
  new = new(ismember (new, breaks));
endfunction

function refuse_prescribed (load, jumps)
  for time = jumps
    before = load_values (load, time*(1 - 2*eps));
    behind = load_values (load, time*(1 + 2*eps));
    for number = load.prescribed
      if (abs (behind(number) - before(number)) > 1e-9*max (abs ([before; behind])))
        scene_error (["%s jumps from %.6g to %.6g at t = %.9g, its number %d: no force can make a prescribed place" ...
                      " or rate jump, let only its acceleration do so"], ...
                     load.name, before(number), behind(number), time, number);
      endif
    endfor
  endfor
endfunction

%!function [breaks, probed] = of (f, stated, prescribed = [], numbers = 1)
%!  scene = struct ("duration", 20, "frames_per_second", 10);
%!  load = load_list ({"moment", f, numbers, "a number", prescribed, numbers == 1});
%!  [breaks, probed] = load_breaks (load, stated, scene);
%!endfunction
%!test # a pulse whose times nobody stated, and with them stated
%! pulse = @(t) 100*(t > 12.3 & t < 12.35);
%! [breaks, probed] = of (pulse, 5);
%! assert (breaks, [5 12.3 12.35], 1e-14); assert (probed.breaks, breaks(2:3)); assert (probed.looked_at, 20011);
%! [breaks, probed] = of (pulse, [12.35 12.3]);
%! assert (breaks, [12.3 12.35]); assert (probed.breaks, zeros (1, 0));
%!test # where a load comes to rest smoothly at a stated time nothing else is found
%! [breaks, probed] = of (@(t) sin (pi*t/3).^4.*(t < 3), 3);
%! assert (breaks, 3); assert (probed.breaks, zeros (1, 0));
%! assert (of (@(t) 1e3*sin (pi*t/3).^4.*(t < 3), 3), 3);
%! assert (of (@(t) 1e-3*sin (pi*t/3).^4.*(t < 3), 3), 3);
%! [breaks, probed] = of (@(t) [(3-min(t,3))^4/12, -(3-min(t,3))^3/3, (3-min(t,3))^2], 3, [1 2], 3);
%! assert (breaks, 3); assert (probed.breaks, zeros (1, 0));
%!test # a time that is stated roughly gives way to what was found
%! assert (of (@(t) t.*(t < 1/3), 0.333333333), 1/3);
%!error <moment jumps from 0 to 1 at t = 3, its number 2: no force can> of (@(t) [0 (t >= 3) 0], [], [1 2], 3)
%!error <moment jumps from 3 to 2 at t = 3, its number 1> of (@(t) [t-(t >= 3), 1, 0], [], [1 2], 3)
%!test # what is stated beside the run is none of its breaks
%! assert (of (@(t) 0*t, [-1 0 5 20 20.00001]), 5);
%!test # stated twice, but for rounding
%! assert (of (@(t) 0*t, [5, 5 + 1e-11, 7]), [5 7], 1e-10);
%!test # an acceleration may
%! [breaks, probed] = of (@(t) [0 0 (t >= 3)], [], [1 2], 3);
%! assert (breaks, 3); assert (probed.looked_at, 4001);
%!test # a thousand jumps are taken, more are not
%! assert (numel (of (@(t) mod (floor (1000.5/20*t), 2), [])), 1000);
%! assert (of (@(t) mod (floor (1001.5/20*t), 2), []), zeros (1, 0));
%!error <moment gives Inf at t = 7.3: it takes> of (@(t) 1./(abs (t - 7.3) > 1e-12), []);  # at a frame alone
%!function t = slower (t)
%!  for k = 1:numel (t)
%!    eig (hilb (60));
%!  endfor
%!endfunction
%!test # a function that takes its time is looked at less often
%! [~, probed] = of (@(t) slower (t), []);
%! assert (probed.looked_at, 1009);
