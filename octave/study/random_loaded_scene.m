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
  kinds = {@hinged, @in_hub, @two_rods, @three_rods};
  scene = with_seed (1000 + seed, kinds{mod (seed - 1, 4) + 1});
  scene.title = sprintf ("Random loaded scene %d", seed);
endfunction

function scene = hinged ()
  [rod, scales] = random_rod ();
  [scene, load] = common (scales);
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
  scene.rotation = @(t) [start, 0, 0] + turning (t/rise, angle, rise, stops);
  scene.moment_breaks = sort ([scene.moment_breaks, rise]);
endfunction

function theta = turning (s, angle, rise, stops)
  r = min (s, 1);
  if (stops)
    theta = angle*[r^3*(10 - 15*r + 6*r^2), 30*r^2*(1 - r)^2/rise, 60*r*(1 - r)*(1 - 2*r)/rise^2];
  else
    theta = angle*[r^3 - r^4/2 + s - r, (3*r^2 - 2*r^3)/rise, 6*r*(1 - r)/rise^2];
  endif
endfunction

## hinged to each other, or welded, and hinged to the ground, clamped, or driven
function scene = two_rods ()
  [rod, scales] = random_rod ();
  [scene, load] = common (scales, 3);
  scene.bodies = {body_of(rod, load.angle), body_of(rod, load.angle)};
  scene.bodies{2}.tip_mass = load.tip_mass;
  held = @() random_pick ({"revolute", "weld"});
  scene.joints = {struct("kind", held (), "bodies", 1, "stations", 0, "direction", load.angle)
                  struct("kind", held (), "bodies", [1 2], "stations", [rod.length 0])
                  struct("kind", "force", "bodies", 2, "stations", rod.length, "value", load.force)};
  if (strcmp (scene.joints{1}.kind, "revolute") && rand () < 0.5)
    drive = @(t) turning (t/scene.duration, 0.003, scene.duration, true) + [load.angle, 0, 0];
    scene.joints{end+1} = struct ("kind", "angle", "bodies", 1, "stations", 0, "value", drive);
  endif
  scene.breaks = load.breaks;
endfunction

## a crank, a rod whose end slides on a line, and a pendulum that hangs from it; or a chain
function scene = three_rods ()
  [rod, scales] = random_rod ();
  [scene, load] = common (scales, 3);
  angle = random_between (0.3, 1);
  l = rod.length;
  scene.bodies = {body_of(rod, angle), body_of(rod, -angle), body_of(rod, -pi/2)};
  scene.bodies{3}.tip_mass = load.tip_mass;
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
                  struct("kind", "revolute", "bodies", [1 2], "stations", [l 0])
                  struct("kind", "revolute", "bodies", [2 3], "stations", [l 0])
                  struct("kind", "force", "bodies", 2, "stations", l, "value", load.force)};
  if (rand () < 0.6)
    scene.joints{end+1} = struct ("kind", "slider", "bodies", 2, "stations", l);
  endif
  scene.breaks = load.breaks;
endfunction

function body = body_of (rod, angle)
  body = struct ("rod", rod, "model", struct ("modes", "auto", "energy", "uniaxial"), ...
                 "initial", struct ("phi", angle));
endfunction

## and its scales: its period of bending (hinged and free), EI/l^2 (N), what stretches it by 0.05 percent (N), mass
## (kg)
function [rod, scales] = random_rod ()
  l = random_between (0.3, 3);
  slenderness = random_between (15, 100);
  E = random_between (2e9, 2e11);
  [half_height, width] = deal (l/slenderness/2, l/slenderness*random_between (0.5, 3));
  rhoA = random_between (1000, 9000)*2*half_height*width;
  EI = E*width*(2*half_height)^3/12;
  EA = random_pick ({E*2*half_height*width, EI/l^2*random_between(100, 3000)});
  rod = struct ("length", l, "EA", EA, "EI", EI, "rhoA", rhoA, "half_height", half_height, ...
                "damping", random_pick ([0 0 1e-5]));
  scales = struct ("period", 2*pi/15.42*l^2*sqrt (rhoA/EI), "EI", EI/l^2, "EA", 5e-4*EA, "length", l, ...
                   "mass", rhoA*l);
endfunction

## mechanisms, which take longer, have a share of the duration, and a larger tolerance
function [scene, load] = common (scales, share = 1)
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
%!test # the hub's rates are derivatives of its angle
%! h = 1e-6;
%! for seed = [2 6 10 14 26 38]  # the last two stop
%!   scene = random_loaded_scene (seed);
%!   for t = scene.duration*[0.05 0.1 0.15 0.7 0.9]
%!     step = h*scene.duration;
%!     slope = (scene.rotation (t + step) - scene.rotation (t - step))/(2*step);
%!     assert (slope(1:2), scene.rotation (t)(2:3), 1e-6*max (abs (scene.rotation (t)(2:3))) + 1e-9);
%!   endfor
%! endfor
%!function [force, masses, angle] = load_of (scene)   # of the rod's tip: largest components, the mass, its angle
%!  if (isfield (scene, "rod"))
%!    force = scene.force;
%!    masses = scene.tip_mass;
%!    angle = NaN;
%!    if (isfield (scene, "initial"))
%!      angle = scene.initial.phi;
%!    endif
%!  else
%!    is_force = cellfun (@(joint) strcmp (joint.kind, "force"), scene.joints);
%!    force = scene.joints{is_force}.value;
%!    masses = scene.bodies{end}.tip_mass;
%!    angle = NaN;
%!    if (numel (scene.bodies) == 2)
%!      angle = scene.bodies{1}.initial.phi;
%!    endif
%!  endif
%!  size = 0;
%!  for t = scene.duration*logspace (-3, 0, 100)
%!    if (norm (force (t)) > norm (size))
%!      size = force (t);
%!    endif
%!  endfor
%!  force = size*[cos(angle) -sin(angle); sin(angle) cos(angle)];  # along and across
%!endfunction
%!test # what is drawn spans the ranges that are stated, in units of the rod (15.42 as in tables of hinged free rods)
%! n = 200;
%! scenes = arrayfun (@random_loaded_scene, 1:n, "uniformoutput", false);
%! single = mod (0:n-1, 4) < 2;
%! assert (cellfun (@(s) isfield (s, "rod"), scenes), single);
%! assert (cellfun (@(s) isfield (s, "rotation"), scenes), mod (0:n-1, 4) == 1);
%! sizes = cellfun (@(s) numel (s.bodies), scenes(! single));
%! assert (sizes, repmat ([2 3], 1, n/4));
%! share = ones (1, n);
%! share(! single) = 3;
%! rods = cellfun (@(s) s.rod, scenes(single), "uniformoutput", false);
%! rods = [rods, cellfun(@(s) s.bodies{1}.rod, scenes(! single), "uniformoutput", false)];
%! scenes = [scenes(single), scenes(! single)];
%! share = sort (share);
%! of = @(take) cellfun (take, scenes);
%! of_rod = @(field) cellfun (@(rod) rod.(field), rods);
%! [l, EI, EA, rhoA] = deal (of_rod ("length"), of_rod ("EI"), of_rod ("EA"), of_rod ("rhoA"));
%! h = 2*of_rod ("half_height");
%! assert_spans (l, 0.3, 3); assert_spans (l./h, 15, 100);
%! one_material = abs (EA.*h.^2./EI - 12) < 1e-9;
%! assert (mean (one_material), 0.5, 0.1);
%! assert_spans ((EA.*l.^2./EI)(! one_material), 100, 3000);
%! assert_spans (rhoA./h.^2, 1000*0.5, 9000*3); assert_spans (12*EI./h.^4, 2e9*0.5, 2e11*3);
%! assert (unique (of_rod ("damping")), [0 1e-5]); assert (mean (of_rod ("damping") == 0), 2/3, 0.1);
%! period = 2*pi/15.42*l.^2.*sqrt (rhoA./EI);
%! g = of (@(s) s.gravity).*rhoA.*l.^3./EI;
%! assert (mean (g == 0), 0.5, 0.1); assert (g <= 0.03*(1 + 1e-9)); assert (of (@(s) s.gravity) <= 9.81);
%! light = g(g > 0 & of (@(s) s.gravity) < 9.81);
%! assert ([min(light), max(light)], [0.001 0.03], -0.3);
%! assert_spans (of (@(s) s.duration)./period.*share, 1, 4);
%! assert (of (@(s) s.duration*s.frames_per_second), 40*ones (1, n), 1e-9);
%! assert_spans (of (@(s) s.solver.tolerance)./l./share, 3e-6, 5e-5);
%! [forces, masses, angles] = cellfun (@load_of, scenes, "uniformoutput", false);
%! masses = [masses{:}]./rhoA./l;
%! assert (mean (masses == 0), 0.5, 0.1); assert_spans (masses(masses > 0), 0.05, 0.5);
%! angles = [angles{:}];
%! known = isfinite (angles);
%! assert ([min(angles), mean(angles(known)), max(angles)]/pi, [-1 0 1], 0.1);
%! size = (vertcat (forces{known}).*(l(known).^2./EI(known)).').';
%! assert (mean (size > 0, 2), [0.5; 0.5], 0.15);
%! soft = 5e-4*(EA.*l.^2./EI)(known) < 0.2;
%! assert (abs (size(1,soft)) <= 5.0001e-4*(EA.*l.^2./EI)(known)(soft));
%! assert_spans (abs (size(1,! soft)), 0.01, 0.2); assert_spans (abs (size(2,:)), 0.0005, 0.005);
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
%!test # joints of two and of three rods
%! of = @(take, first) cellfun (take, arrayfun (@random_loaded_scene, first:4:200, "uniformoutput", false));
%! welds = @(s) [strcmp(s.joints{1}.kind, "weld"); strcmp(s.joints{2}.kind, "weld")];
%! for number = 1:2
%!   assert (mean (of (@(s) welds (s)(number), 3)), 0.5, 0.2);
%! endfor
%! assert (of (@(s) s.joints{2}.stations(1)/s.bodies{1}.rod.length, 3), ones (1, 50));
%! assert (of (@(s) s.joints{3}.stations/s.bodies{1}.rod.length, 3), ones (1, 50));
%! driven = of (@(s) numel (s.joints) == 4, 3);
%! assert (mean (driven), 0.25, 0.15);
%! turn = @(s) (s.joints{end}.value (s.duration) - [s.bodies{1}.initial.phi, 0, 0])(1:2);
%! for seed = (3:4:200)(driven)
%!   assert (turn (random_loaded_scene (seed)), [0.003, 0], 1e-9);
%! endfor
%! assert_spans (of (@(s) s.bodies{1}.initial.phi, 4), 0.3, 1);
%! assert (of (@(s) s.bodies{1}.initial.phi + s.bodies{2}.initial.phi, 4), zeros (1, 50));
%! assert (of (@(s) s.bodies{3}.initial.phi, 4), -pi/2*ones (1, 50), 1e-12);
%! assert (mean (of (@(s) numel (s.joints) == 5, 4)), 0.6, 0.2);
%! assert (of (@(s) s.joints{4}.stations/s.bodies{2}.rod.length, 4), ones (1, 50));
