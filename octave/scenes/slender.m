## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} slender ()
## A steel wire of l/2h = 500 falls from the horizontal.  Its frequencies are low and its deflection is seen without
## zoom: a few bending modes, with the foreshortening that goes with large deflections.
## @end deftypefn

function scene = slender ()
  scene.title = "A slender rod falls";
  scene.rod.length = 1;
  scene.rod.width = 0.01;
  scene.rod.half_height = 0.001;
  scene.duration = 1.2;
  scene.model.energy = "uniaxial";
endfunction

%!assert (slender ().rod.length/(2*slender ().rod.half_height), 500)
