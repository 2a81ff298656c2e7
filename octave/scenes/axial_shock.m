## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} axial_shock ()
## A bar pulled by 0.1 mm at its end and let go: a longitudinal wave runs to and fro, once in 0.8 ms.  There is nothing
## else to look at, and it takes many dynamic longitudinal modes, since the wave has a front.
## @end deftypefn

function scene = axial_shock ()
  scene.title = "A stretched bar is let go";
  scene.rod.length = 1;
  scene.rod.width = 0.02;
  scene.rod.half_height = 0.01;
  k = 2*(1:30) - 1;
  scene.initial.V1 = -1e-4*8/pi^2*cos (pi*(1:30))./k.^2;
  scene.duration = 0.002;
  scene.frames_per_second = 40000;
  scene.zoom = 1000;
  scene.model.energy = "uniaxial";
endfunction

%!test # 0.1 mm at the end, and the same strain all along
%! V1 = axial_shock ().initial.V1; k = 1:30;
%! assert (sum (V1.*sin (pi/2*(2*k - 1))), 1e-4, 1e-6);
%! assert (sum (V1.*sin (pi/4*(2*k - 1))), 5e-5, 1e-7);
