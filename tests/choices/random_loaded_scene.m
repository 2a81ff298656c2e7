## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_loaded_scene (@var{seed})
## A scene drawn at random with forces along and across rods and masses at their tips: by turns a hinged rod, one in a
## hub that turns, a mechanism of two rods and one of three.
##
## Forces are scaled to the rods, so that these bend by up to half a hundredth of their length and stretch by at most
## 0.05 percent, within what foreshortening holds for: where they bend more, no model of the ladder keeps such
## tolerances, and runs say so (see @code{error_warning}).  Half of the rods are softer along than a rod of one
## material is.
## @end deftypefn

function scene = random_loaded_scene (seed)
  kinds = {@hinged, @in_hub, @() random_mechanism (2), @() random_mechanism (3)};
  scene = with_seed (1000 + seed, kinds{mod (seed - 1, 4) + 1});
  scene.title = sprintf ("Random loaded scene %d", seed);
endfunction

function scene = hinged ()
  [rod, scales] = random_rod ();
  [scene, load] = random_loading (scales);
  scene.rod = rod;
  scene.initial.phi = load.angle;
  [scene.force, scene.moment_breaks] = deal (load.force, load.breaks);
  scene.force_station = rod.length*random_pick ([1 1 0.7]);
  scene.tip_mass = load.tip_mass;
  scene.model.energy = "uniaxial";
endfunction

## from 0 to rest at some angle, or on at a steady rate, by a polynomial
function scene = in_hub ()
  scene = hinged ();
  start = scene.initial.phi;
  scene = rmfield (scene, "initial");
  angle = random_between (0.0003, 0.003);  # within a few periods of bending: the rod lags by as much as forces bend it
  rise = scene.duration*random_between (0.2, 0.6);
  stops = rand () < 0.5;
  turn = smooth_turn (angle, rise, stops);
  scene.rotation = @(t) [start, 0, 0] + turn (t);
  scene.moment_breaks = sort ([scene.moment_breaks, rise]);
endfunction

%!test # the same seed gives the same scene, and all kinds are scenes
%! assert (random_loaded_scene (1).rod, random_loaded_scene (1).rod);
%! for seed = 1:8
%!   scene = random_loaded_scene (seed);
%!   kind = kind_of (scene);
%!   checked = kind.check (scene);
%!   ladder = kind.ladder (checked);
%!   [first, ~] = ladder.first ();
%!   system = kind.system (checked, kind.build (checked, ladder.richer (first)));
%!   assert (system.warnings, {});
%! endfor
%!test # by turns a rod, one in a hub, two rods and three; the load is of the rods' size, the tolerance of the kind's
%! scenes = arrayfun (@random_loaded_scene, 1:200, "uniformoutput", false);
%! single = mod (0:199, 4) < 2;
%! assert (cellfun (@(s) isfield (s, "rod"), scenes), single);
%! assert (cellfun (@(s) isfield (s, "rotation"), scenes), mod (0:199, 4) == 1);
%! assert (cellfun (@(s) numel (s.bodies), scenes(! single)), repmat ([2 3], 1, 50));
%! rods = cellfun (@(s) s.rod, scenes(single));
%! assert_spans (cellfun (@(s) s.solver.tolerance, scenes(single))./[rods.length], 3e-6, 5e-5);
%! masses = cellfun (@(s) s.tip_mass, scenes(single))./[rods.rhoA]./[rods.length];
%! assert (mean (masses == 0), 0.5, 0.2); assert_spans (masses(masses > 0), 0.05, 0.5);
%! largest = @(s) max (arrayfun (@(t) norm (s.force (t)), s.duration*10.^(-3:0.25:0)));
%! force = cellfun (largest, scenes(single)).*[rods.length].^2./[rods.EI];
%! assert (force <= hypot (0.2, 0.005) & force > 0.0005/2);
%! assert (any (cellfun (@(s) s.force_station < s.rod.length, scenes(single))));
%!test # hubs turn by the angle from rest, in a share of the time, and stop, or go on at the rate angle/rise
%! for k = 1:100
%!   scene = random_loaded_scene (4*k - 2);
%!   turned = scene.rotation (scene.duration) - [scene.rotation(0)(1), 0, 0];
%!   assert (scene.rotation (0)(2:3), [0 0]); assert (turned(3), 0);
%!   stops(k) = turned(2) == 0;
%!   angle(k) = turned(1);
%!   rise = max (scene.moment_breaks);
%!   if (! stops(k))
%!     angle(k) = 2*(turned(2)*scene.duration - turned(1));
%!     rise = angle(k)/turned(2);
%!   endif
%!   assert (any (abs (scene.moment_breaks - rise) < 1e-9*scene.duration));
%!   share(k) = rise/scene.duration;
%! endfor
%! assert (mean (stops), 0.5, 0.15); assert_spans (angle, 0.0003, 0.003); assert_spans (share(! stops), 0.2, 0.6);
