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

%!test # with 4 % of critical damping a half is left after three periods, an eighth after nine
%! scene = check_scene (damped ());
%! section = rod_section (scene.rod, scene.model);
%! omega = 15.4182*sqrt (section.EI/section.rhoA)/scene.rod.length^2;  # hinged and free
%! left = @(periods) exp (-scene.rod.damping*omega/2*omega*periods*2*pi/omega);
%! assert (left (3), 1/2, 0.1); assert (left (9), 1/8, 0.05);
%! assert (scene.moment ([0.0999 0.1]), [30 0]);
