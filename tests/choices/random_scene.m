## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_scene (@var{seed})
## A scene drawn at random: lengths from 0.2 to 5 m, slenderness from 20 to 500, steel to rubber-like stiffness, a
## pulse or a step of the moment, an initial state, with or without damping.  The moment is scaled to the rod, and
## gravity is less than the earth's where it would bend the rod too far for small slopes.
## @end deftypefn

function scene = random_scene (seed)
  scene = with_seed (seed, @drawn_scene);
  scene.title = sprintf ("Random scene %d", seed);
endfunction

function scene = drawn_scene ()
  [length, slenderness] = deal (random_between (0.2, 5), random_between (20, 500));
  rod.length = length;
  rod.half_height = length/slenderness/2;
  rod.width = rod.half_height*random_between (0.5, 5);
  rod.mu = random_between (1e9, 1e11);
  rod.lambda = rod.mu*random_between (0.5, 2);
  rod.density = random_between (1000, 9000);
  rod.damping = (rand () < 0.3)*1e-5;
  scene.rod = rod;
  scene.model.energy = random_pick ({"uniaxial", "paper"});
  EI = rod.mu*2.6*rod.width*(2*rod.half_height)^3/12;
  period = 2*pi/15.4*sqrt (rod.density*rod.width*2*rod.half_height/EI)*length^2;
  scene.gravity = min (9.81, random_between (0.01, 1)*EI/(rod.density*rod.width*2*rod.half_height*length^3));
  moment = random_between (1e-3, 0.1)*EI/length;
  duration = period*random_between (0.1, 10);
  if (rand () < 0.5)
    scene.moment = @(t) moment*(t < duration);
  else
    scene.moment = @(t) moment*sin (pi*t/duration).*(t < duration);
  endif
  scene.moment_breaks = duration;
  scene.initial.phi = pi*(2*rand () - 1);
  scene.initial.phi_dot = (rand () < 0.3)*0.5/period;
  scene.initial.V2 = (rand () < 0.3)*length*random_between (1e-4, 1e-2)*[1, rand() - 0.5];
  scene.duration = period*random_between (3, 30);
  scene.frames_per_second = 60/scene.duration;
  scene.zoom = random_between (1, 100);
endfunction

%!test # the same seed gives the same scene, another one another
%! assert (random_scene (3).rod, random_scene (3).rod);
%! assert (! isequal (random_scene (3).rod, random_scene (4).rod));
%! check_scene (random_scene (5));
%!test # what is drawn spans the ranges that are stated, and loads and times are those of the rod (15.4 as in tables)
%! scenes = arrayfun (@random_scene, 1:300, "uniformoutput", false);
%! of = @(take) cellfun (take, scenes);
%! l = of (@(s) s.rod.length);
%! h = of (@(s) 2*s.rod.half_height);
%! rhoA = of (@(s) s.rod.density*s.rod.width).*h;
%! EI = 2.6*of (@(s) s.rod.mu*s.rod.width).*h.^3/12;
%! period = l.^2.*sqrt (rhoA./EI)*2*pi/15.4;
%! assert_spans (l, 0.2, 5); assert_spans (l./h, 20, 500); assert_spans (2*of (@(s) s.rod.width)./h, 0.5, 5);
%! assert_spans (of (@(s) s.rod.mu), 1e9, 1e11); assert_spans (of (@(s) s.rod.lambda/s.rod.mu), 0.5, 2);
%! assert_spans (of (@(s) s.rod.density), 1e3, 9e3); assert_spans (of (@(s) s.zoom), 1, 100);
%! g = of (@(s) s.gravity);
%! assert (g <= 9.81 & g <= 1.001*EI./(rhoA.*l.^3)); assert (mean (g == 9.81), 0.5, 0.2);
%! light = g(g < 9.81).*(rhoA.*l.^3./EI)(g < 9.81);
%! assert ([min(light), max(light)], [0.01 1], -0.3);
%! ends = of (@(s) s.moment_breaks);
%! assert_spans (ends./period, 0.1, 10); assert_spans (of (@(s) s.duration)./period, 3, 30);
%! assert (of (@(s) s.duration*s.frames_per_second), 60*ones (1, 300), 1e-9);
%! assert_spans (of (@(s) s.moment (s.moment_breaks/2)).*l./EI, 1e-3, 0.1);
%! assert (of (@(s) s.moment (1.001*s.moment_breaks)), zeros (1, 300));
%! start = of (@(s) s.moment (0)) == 0;  # a half wave, or a step
%! assert (mean (start), 0.5, 0.1);
%! assert (of (@(s) s.moment (s.moment_breaks/6)/s.moment (s.moment_breaks/2)), 1 - start/2, 1e-9);
%! phi = of (@(s) s.initial.phi);
%! assert ([min(phi), mean(phi), max(phi)]/pi, [-1 0 1], 0.1);
%! for share = {@(s) s.rod.damping*1e5, @(s) s.initial.phi_dot > 0, @(s) s.initial.V2(1) > 0}
%!   assert (mean (of (share{1})), 0.3, 0.1);
%! endfor
%! turning = of (@(s) s.initial.phi_dot).*period;
%! assert (turning(turning > 0), 0.5*ones (1, sum (turning > 0)), 1e-9);
%! bent = of (@(s) s.initial.V2(1)/s.rod.length);
%! assert_spans (bent(bent > 0), 1e-4, 1e-2);
%! second = of (@(s) s.initial.V2(2))./of (@(s) s.initial.V2(1));
%! assert ([min(second), max(second)], [-0.5 0.5], 0.1);
%! assert (mean (of (@(s) strcmp (s.model.energy, "paper"))), 0.5, 0.1);
