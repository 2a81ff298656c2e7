## -*- texinfo -*-
## @deftypefn {} {[@var{rod}, @var{scales}] =} random_rod ()
## A rod drawn at random (see @code{scene_fields}), half of them softer along than one of one material is, and its
## @var{scales}: period (s, of bending, hinged and free), EI (EI/l^2, N), EA (what stretches it by 0.05 percent, N),
## length (m) and mass (kg).
## @end deftypefn

function [rod, scales] = random_rod ()
  l = random_between (0.3, 3);
  slenderness = random_between (15, 100);
  E = random_between (2e9, 2e11);
  [half_height, width] = deal (l/slenderness/2, l/slenderness*random_between (0.5, 3));
  rhoA = random_between (1000, 9000)*2*half_height*width;
  EI = E*width*(2*half_height)^3/12;
  EA = random_pick ({E*2*half_height*width, EI/l^2*random_between(100, 3000)});
  rod = struct ("length", l, "EA", EA, "EI", EI, "rhoA", rhoA, "half_height", half_height, ...
                "damping", random_pick ([0 0 1e-5]));
  scales = struct ("period", 2*pi/15.42*l^2*sqrt (rhoA/EI), "EI", EI/l^2, "EA", 5e-4*EA, "length", l, ...
                   "mass", rhoA*l);
endfunction

%!function [rods, scales] = drawn (n)
%!  for k = 1:n
%!    [rods(k), scales(k)] = random_rod ();
%!  endfor
%!endfunction
%!test # what is drawn spans the ranges that are stated, in units of the rod (15.42 as in tables of hinged free rods)
%! pairs = with_seed (1, @() nthargout (1:2, @drawn, 200));
%! [rods, scales] = pairs{:};
%! [l, EI, EA, rhoA] = deal ([rods.length], [rods.EI], [rods.EA], [rods.rhoA]);
%! h = 2*[rods.half_height];
%! assert_spans (l, 0.3, 3); assert_spans (l./h, 15, 100);
%! one_material = abs (EA.*h.^2./EI - 12) < 1e-9;
%! assert (mean (one_material), 0.5, 0.1);
%! assert_spans ((EA.*l.^2./EI)(! one_material), 100, 3000);
%! assert_spans (rhoA./h.^2, 1000*0.5, 9000*3); assert_spans (12*EI./h.^4, 2e9*0.5, 2e11*3);
%! assert (unique ([rods.damping]), [0 1e-5]); assert (mean ([rods.damping] == 0), 2/3, 0.1);
%! assert ([scales.period], 2*pi/15.42*l.^2.*sqrt (rhoA./EI), -1e-12);
%! assert ([scales.EI], EI./l.^2, -1e-12); assert ([scales.EA], 5e-4*EA, -1e-12);
%! assert ([scales.length], l); assert ([scales.mass], rhoA.*l, -1e-12);
