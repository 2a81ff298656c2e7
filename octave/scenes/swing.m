## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} swing ()
## A short, thick steel rod let go from the horizontal.  Its lowest bending frequency is 800 times that of its swing,
## and its own weight bends it by micrometres: the rigid rod is enough.
## @end deftypefn

function scene = swing ()
  scene.title = "A stiff rod swings";
  scene.rod.length = 0.5;
  scene.rod.width = 0.04;
  scene.rod.half_height = 0.02;
  scene.duration = 2;
endfunction

%!test # hinged and free it vibrates 800 times as fast as it swings; its weight bends it by 2 micrometres
%! scene = check_scene (swing ());
%! section = rod_section (scene.rod, scene.model);
%! l = scene.rod.length;
%! assert (15.4182*sqrt (section.EI/section.rhoA)/l^2/sqrt (1.5*9.81/l), 800, 20);
%! assert (5*section.rhoA*9.81*l^4/(384*section.EI), 1.6e-6, 0.1e-6);
