## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_scene (@var{seed})
## A scene drawn at random: lengths from 0.2 to 5 m, slenderness from 20 to 500, steel to rubber-like stiffness, a
## pulse or a step of the moment, an initial state, with or without damping.  The moment is scaled to the rod, and
## gravity is less than the earth's where it would bend the rod too far for small slopes.
## @end deftypefn

function scene = random_scene (seed)
  state = rand ("twister");
  unwind_protect
    rand ("twister", seed);
    scene = drawn_scene ();
  unwind_protect_cleanup
    rand ("twister", state);
  end_unwind_protect
  scene.title = sprintf ("Random scene %d", seed);
endfunction

function scene = drawn_scene ()
  between = @(low, high) low*(high/low)^rand ();
  [length, slenderness] = deal (between (0.2, 5), between (20, 500));
  rod.length = length;
  rod.half_height = length/slenderness/2;
  rod.width = rod.half_height*between (0.5, 5);
  rod.mu = between (1e9, 1e11);
  rod.lambda = rod.mu*between (0.5, 2);
  rod.density = between (1000, 9000);
  rod.damping = (rand () < 0.3)*1e-5;
  scene.rod = rod;
  scene.model.energy = {"paper", "uniaxial"}{1 + (rand () < 0.5)};
  EI = rod.mu*2.6*rod.width*(2*rod.half_height)^3/12;
  period = 2*pi/15.4*sqrt (rod.density*rod.width*2*rod.half_height/EI)*length^2;
  scene.gravity = min (9.81, between (0.01, 1)*EI/(rod.density*rod.width*2*rod.half_height*length^3));
  moment = between (1e-3, 0.1)*EI/length;
  duration = period*between (0.1, 10);
  if (rand () < 0.5)
    scene.moment = @(t) moment*(t < duration);
  else
    scene.moment = @(t) moment*sin (pi*t/duration).*(t < duration);
  endif
  scene.moment_breaks = duration;
  scene.initial.phi = pi*(2*rand () - 1);
  scene.initial.phi_dot = (rand () < 0.3)*0.5/period;
  scene.initial.V2 = (rand () < 0.3)*length*between (1e-4, 1e-2)*[1, rand() - 0.5];
  scene.duration = period*between (3, 30);
  scene.frames_per_second = 60/scene.duration;
  scene.zoom = between (1, 100);
endfunction

%!test # the same seed gives the same scene, another one another
%! assert (random_scene (3).rod, random_scene (3).rod);
%! assert (! isequal (random_scene (3).rod, random_scene (4).rod));
%! check_scene (random_scene (5));
