## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_mechanism (@var{count})
## A mechanism of two equal rods, or of three, drawn at random (see @code{random_rod} and @code{random_loading}).
## @end deftypefn

function scene = random_mechanism (count)
  if (count == 2)
    scene = two_rods ();
  else
    scene = three_rods ();
  endif
endfunction

## hinged to each other, or welded, and hinged to the ground, clamped, or driven
function scene = two_rods ()
  [rod, scales] = random_rod ();
  [scene, load] = random_loading (scales, 3);
  scene.bodies = {body_of(rod, load.angle), body_of(rod, load.angle)};
  scene.bodies{2}.tip_mass = load.tip_mass;
  held = @() random_pick ({"revolute", "weld"});
  scene.joints = {struct("kind", held (), "bodies", 1, "stations", 0, "direction", load.angle)
                  struct("kind", held (), "bodies", [1 2], "stations", [rod.length 0])
                  struct("kind", "force", "bodies", 2, "stations", rod.length, "value", load.force)};
  if (strcmp (scene.joints{1}.kind, "revolute") && rand () < 0.5)
    turn = smooth_turn (0.003, scene.duration, true);
    drive = @(t) turn (t) + [load.angle, 0, 0];
    scene.joints{end+1} = struct ("kind", "angle", "bodies", 1, "stations", 0, "value", drive);
  endif
  scene.breaks = load.breaks;
endfunction

## a crank, a rod whose end slides on a line, and a pendulum that hangs from it; or a chain
function scene = three_rods ()
  [rod, scales] = random_rod ();
  [scene, load] = random_loading (scales, 3);
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

%!test # joints of two and of three rods, and a larger tolerance
%! drawn = @(count) arrayfun (@(seed) with_seed (seed, @() random_mechanism (count)), 1:50, "uniformoutput", false);
%! scenes = {[], drawn(2), drawn(3)};
%! of = @(take, count) cellfun (take, scenes{count});
%! welds = @(s) [strcmp(s.joints{1}.kind, "weld"); strcmp(s.joints{2}.kind, "weld")];
%! for number = 1:2
%!   assert (mean (of (@(s) welds (s)(number), 2)), 0.5, 0.2);
%! endfor
%! assert (of (@(s) s.joints{2}.stations(1)/s.bodies{1}.rod.length, 2), ones (1, 50));
%! assert (of (@(s) s.joints{3}.stations/s.bodies{1}.rod.length, 2), ones (1, 50));
%! driven = of (@(s) numel (s.joints) == 4, 2);
%! assert (mean (driven), 0.25, 0.15);
%! turn = @(s) (s.joints{end}.value (s.duration) - [s.bodies{1}.initial.phi, 0, 0])(1:2);
%! turned = cell2mat (cellfun (turn, scenes{2}(driven).', "uniformoutput", false));
%! assert (turned, repmat ([0.003 0], sum (driven), 1), 1e-9);
%! tolerance = @(s) s.solver.tolerance/s.bodies{1}.rod.length;
%! assert_spans ([of(tolerance, 2), of(tolerance, 3)], 9e-6, 1.5e-4);
%! masses = of (@(s) s.bodies{2}.tip_mass > 0, 2); assert (mean (masses), 0.5, 0.2);
%! masses = of (@(s) s.bodies{3}.tip_mass > 0, 3); assert (mean (masses), 0.5, 0.2);
%! assert_spans (of (@(s) s.bodies{1}.initial.phi, 3), 0.3, 1);
%! assert (of (@(s) s.bodies{1}.initial.phi + s.bodies{2}.initial.phi, 3), zeros (1, 50));
%! assert (of (@(s) s.bodies{3}.initial.phi, 3), -pi/2*ones (1, 50), 1e-12);
%! assert (mean (of (@(s) numel (s.joints) == 5, 3)), 0.6, 0.2);
%! assert (of (@(s) s.joints{4}.stations/s.bodies{2}.rod.length, 3), ones (1, 50));
