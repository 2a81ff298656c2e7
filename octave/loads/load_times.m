## -*- texinfo -*-
## @deftypefn {} {@var{times} =} load_times (@var{scene})
## Times (1-by-m, s) at which whatever the moment of a checked scene with one rod does is seen: 1000 of the run, and 21
## from each of its breaks to the next, from inside.
## @end deftypefn

function times = load_times (scene)
  [~, ends] = meet_breaks ([0, scene.duration], scene.breaks);
  times = linspace (0, scene.duration, 1000);
  for k = 1:numel (ends) - 1
    inside = inside_of (ends([k, k+1]));
    times = [times, linspace(inside(1), inside(2), 21)];
  endfor
endfunction

%!test # a pulse of a ten-thousandth of the run
%! scene = struct ("duration", 100, "breaks", [50.003 50.013]);
%! assert (any (load_times (scene) > 50.003 & load_times (scene) < 50.013));
%!test # between all ends, and nowhere else
%! scene = struct ("duration", 100, "breaks", [-1 0.01 0.02 99.98 99.99 101]);
%! times = load_times (scene);
%! for gap = [0 0.01 0.02 99.98 99.99; 0.01 0.02 99.98 99.99 100]
%!   inside = sum (times > gap(1) & times < gap(2));
%!   assert (inside, 21 + 998*(diff (gap) > 1));
%! endfor
%! assert (times >= 0 & times <= 100);
