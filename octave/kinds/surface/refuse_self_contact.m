## -*- texinfo -*-
## @deftypefn {} {} refuse_self_contact (@var{history}, @var{scene})
## An error where two points of the rod, further apart along it than twice its height, come nearer in space than its
## height (2*half_height): the model lets a rod pass through itself.  The ends of a rod that starts closed are beside
## each other.
## @end deftypefn

function refuse_self_contact (history, scene)
  p = rows (history.x);
  height = 2*scene.rod.half_height;
  spacing = scene.rod.length/(p - 1);
  near = max (height, 0.75*spacing)^2;
  apart = (1:p) - (1:p).';
  along = apart;
  if (norm ([diff(history.x([1 p],1)), diff(history.y([1 p],1)), diff(history.z([1 p],1))])^2 < near)
    along = min (apart, p - 1 - apart);
  endif
  [i, j] = find (along >= ceil (2*height/spacing) + 2);
  for k = 1:numel (history.t)
    far = (history.x(i,k) - history.x(j,k)).^2 + (history.y(i,k) - history.y(j,k)).^2 ...
          + (history.z(i,k) - history.z(j,k)).^2;
    [least, nearest] = min (far);
    if (least < near)
      text = ["the rod touches itself at t = %.4g s, %.3g m and %.3g m along it: contact of the rod with itself" ...
              " is not modelled; take a stiffer rod, a shorter time or another start\n"];
      error ("toolchain:integration", text, history.t(k), (i(nearest) - 1)*spacing, (j(nearest) - 1)*spacing);
    endif
  endfor
endfunction

%!error <the rod touches itself at t = 2 s, 0 m and 6.\d* m along it>
%! s = linspace (0, 2*pi, 101).';
%! refuse_self_contact (struct ("t", [1 2], "x", [s, cos(s)], "y", [0*s, sin(s)], "z", [s s]*0), ...
%!                      struct ("rod", struct ("length", 2*pi, "half_height", 0.01)));
%!error <the rod touches itself at t = 0 s, 0.48 m and 0.52 m along it> # a fold of 4 cm, after which it leads away
%! s = (0:100).';
%! x = min (s, max (100 - s, 46));
%! refuse_self_contact (struct ("t", 0, "x", x/100, "y", max (s - 54, 0)/100, "z", 0*s), ...
%!                      struct ("rod", struct ("length", 1, "half_height", 0.002)));
%!test # neighbours along a rod are near each other, and no contact; nor is a coil that stays a height apart
%! s = (0:100).'/100;
%! scene = struct ("rod", struct ("length", 1, "half_height", 0.03));
%! refuse_self_contact (struct ("t", 0, "x", s, "y", 0*s, "z", 0*s), scene);
%! coil = @(rise) struct ("t", 0, "x", cos (8*pi*s)*0.039, "y", sin (8*pi*s)*0.039, "z", rise*4*s);
%! refuse_self_contact (coil (0.064), scene);
%! fail ("refuse_self_contact (coil (0.058), scene)", "the rod touches itself at t = 0 s");
%!test # a ring that is cut where it hangs from starts closed, and opens
%! s = linspace (0, 2*pi, 101).';
%! opening = struct ("t", [0 1], "x", [cos(s), cos(0.9*s)], "y", [sin(s), sin(0.9*s)], "z", [s s]*0);
%! refuse_self_contact (opening, struct ("rod", struct ("length", 2*pi, "half_height", 0.01)));
