## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{load}] =} random_loading (@var{scales}, @var{share})
## Weight, duration and tolerance of a @var{scene} drawn at random, and a @var{load}, for rods of these @var{scales}
## (see @code{random_rod}): a struct of angle (rad, of the rod at the start), tip_mass (kg), force (t) (N, [x y], along
## and across that rod) and breaks (s).  Mechanisms, which take longer, have 1/@var{share} of the duration, and so many
## times the tolerance.
## @end deftypefn

function [scene, load] = random_loading (scales, share = 1)
  scene.gravity = random_pick ([0, 1])*min (9.81, random_between (0.001, 0.03)*scales.EI/scales.mass);
  scene.duration = scales.period*random_between (1, 4)/share;
  scene.frames_per_second = 40/scene.duration;
  scene.solver.tolerance = share*scales.length*random_between (3e-6, 5e-5);
  load.angle = pi*(2*rand () - 1);
  load.tip_mass = random_pick ([0 1])*scales.mass*random_between (0.05, 0.5);
  size = [random_pick([-1 1])*min(random_between (0.01, 0.2)*scales.EI, scales.EA)
          random_pick([-1 1])*random_between(0.0005, 0.005)*scales.EI];
  size = [cos(load.angle) -sin(load.angle); sin(load.angle) cos(load.angle)]*size;  # along and across the rod
  ending = scales.period*random_between (0.1, 2);
  course = random_pick ({@(t) t < ending, @(t) sin(pi*t/ending)*(t < ending), @(t) sin(2*pi*t/ending)});
  load.force = @(t) course (t)*size.';
  load.breaks = ending(ending < scene.duration);
endfunction

%!function [rods, scales, scenes, loads] = drawn (n, share)
%!  for k = 1:n
%!    [rods(k), scales(k)] = random_rod ();
%!    [scenes(k), loads(k)] = random_loading (scales(k), share);
%!  endfor
%!endfunction
%!function size = largest (load, period)   # along and across the rod
%!  at = cell2mat (arrayfun (@(t) load.force (t), period*logspace (-3, 0.3, 300).', "uniformoutput", false));
%!  [~, k] = max (sumsq (at, 2));
%!  size = at(k,:)*[cos(load.angle) -sin(load.angle); sin(load.angle) cos(load.angle)];
%!endfunction
%!test # what is drawn spans the ranges that are stated, in units of the rod
%! for share = [1 3]
%!   all = with_seed (1, @() nthargout (1:4, @drawn, 200, share));
%!   [rods, scales, scenes, loads] = all{:};
%!   [l, EI, EA] = deal ([rods.length], [rods.EI], [rods.EA]);
%!   g = [scenes.gravity].*[rods.rhoA].*l.^3./EI;
%!   assert (mean (g == 0), 0.5, 0.1); assert (g <= 0.03*(1 + 1e-9)); assert ([scenes.gravity] <= 9.81);
%!   light = g(g > 0 & [scenes.gravity] < 9.81);
%!   assert ([min(light), max(light)], [0.001 0.03], -0.3);
%!   assert_spans ([scenes.duration]./[scales.period]*share, 1, 4);
%!   assert ([scenes.duration].*[scenes.frames_per_second], 40*ones (1, 200), 1e-9);
%!   assert_spans (arrayfun (@(scene) scene.solver.tolerance, scenes)./l/share, 3e-6, 5e-5);
%!   masses = [loads.tip_mass]./[scales.mass];
%!   assert (mean (masses == 0), 0.5, 0.1); assert_spans (masses(masses > 0), 0.05, 0.5);
%!   assert ([min([loads.angle]), mean([loads.angle]), max([loads.angle])]/pi, [-1 0 1], 0.1);
%!   size = cell2mat (arrayfun (@largest, loads, [scales.period], "uniformoutput", false).').'.*(l.^2./EI);
%!   assert (mean (size > 0, 2), [0.5; 0.5], 0.15);
%!   soft = 5e-4*EA.*l.^2./EI < 0.2;
%!   assert (abs (size(1,soft)) <= 5.0001e-4*(EA.*l.^2./EI)(soft));
%!   assert_spans (abs (size(1,! soft)), 0.01, 0.2); assert_spans (abs (size(2,:)), 0.0005, 0.005);
%! endfor
