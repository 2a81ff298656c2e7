## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} hammer ()
## A blow of 0.2 ms at the hinge.  Its spectrum reaches 30000 rad/s, and each of the many modes below that is seen as a
## wave that runs along the rod.
## @end deftypefn

function scene = hammer ()
  scene.title = "A blow at the hinge";
  scene.rod.length = 1;
  scene.rod.width = 0.02;
  scene.rod.half_height = 0.01;
  scene.moment = @(t) 2000*sin (pi*t/2e-4).*(t < 2e-4);
  scene.moment_breaks = 2e-4;
  scene.duration = 0.01;
  scene.frames_per_second = 10000;
  scene.zoom = 20;
  scene.model.energy = "uniaxial";
endfunction

%!test # the blow
%! assert (hammer ().moment ([0 1e-4 2e-4 1]), [0 2000 0 0], 1e-9);
