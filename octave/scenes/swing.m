## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} swing ()
## A short, thick steel rod let go from the horizontal.  Its lowest bending frequency is 2000 times that of its swing,
## and its own weight bends it by micrometres: the rigid rod is enough.
## @end deftypefn

function scene = swing ()
  scene.title = "A stiff rod swings";
  scene.rod.length = 0.5;
  scene.rod.width = 0.04;
  scene.rod.half_height = 0.02;
  scene.duration = 2;
endfunction

%!assert (fieldnames (swing ()), {"title"; "rod"; "duration"})
