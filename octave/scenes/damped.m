## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} damped ()
## The paper's rod with a material that dissipates (Kelvin and Voigt): after the jump of the moment the vibration dies
## out within a few periods, the higher modes first, so that fewer of them are needed.
## @end deftypefn

function scene = damped ()
  scene = paper ();
  scene.title = "A rod that dissipates";
  scene.rod.damping = 1e-4;
  scene.moment = @(t) 30*(t < 0.1);
  scene.moment_breaks = 0.1;
  scene.duration = 0.5;
  scene.frames_per_second = 200;
endfunction

%!assert (damped ().rod.damping, 1e-4)
