## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_linkage (@var{seed})
## A linkage of one to six rods drawn at random (see @code{random_rod}): a chain from the ground, of three rods on half
## of them closed by a hinge at its end, with springs between rods and to the ground of 1 to 1e9 (N m/rad, N/m), that
## rest as it begins, dampers, a moment that jumps, or an angle of the first rod whose acceleration jumps.
##
## Weight and moment are scaled to the rods, so that these bend by some hundredths of their length at most.
## @end deftypefn

function scene = random_linkage (seed)
  count = mod (seed - 1, 6) + 1;
  scene = with_seed (2000 + seed, @() linkage (count));
  scene.title = sprintf ("Random linkage %d", seed);
endfunction

function scene = linkage (count)
  angle = 2*pi*rand ();
  tip = [0 0];
  joints = {};
  for k = 1:count
    [rod, scales(k)] = random_rod ();
    model = struct ("modes", random_pick ({[0 0], [0 1], [0 2], [1 2]}), "energy", "uniaxial");
    scene.bodies{k} = struct ("rod", rod, "model", model, "initial", struct ("phi", angle));
    before = [k - 1, k](1 + (k == 1):end);  # the first hangs on the ground
    joints{end+1} = struct ("kind", "revolute", "bodies", before, "stations", station_before (scene, k));
    if (rand () < 0.4)
      phi = cellfun (@(body) body.initial.phi, scene.bodies(before));
      rest = phi(1) - [phi(2:end), 0](1);
      joints{end+1} = spring_at_rest ("torsion_spring", before, station_before (scene, k), [0 0], rest);
    endif
    tip += rod.length*[cos(angle), sin(angle)];
    angle += random_pick ([-1 1])*random_between (0.3, 2);
  endfor
  if (count > 2 && rand () < 0.5)
    joints{end+1} = struct ("kind", "revolute", "bodies", count, "stations", rod.length, "point", tip);
  elseif (rand () < 0.5)
    point = tip + random_between (0.2, 2)*[cos(angle), sin(angle)];
    joints{end+1} = spring_at_rest ("spring", count, rod.length, point, norm (point - tip));
  endif
  scene.duration = random_between (0.1, 1);
  scene.frames_per_second = 20/scene.duration;
  scene.breaks = scene.duration*rand ();
  joints{end+1} = driven (scene, min ([scales.EI].*[scales.length]));
  scene.joints = joints(:);
  scene.gravity = min ([9.81, 0.05/count*[scales.EI]./[scales.mass]]);
  scene.solver.tolerance = 1e-5*sum ([scales.length]);
endfunction

function stations = station_before (scene, k)
  stations = 0;
  if (k > 1)
    stations = [scene.bodies{k-1}.rod.length, 0];
  endif
endfunction

function joint = spring_at_rest (kind, bodies, stations, point, rest)
  joint = struct ("kind", kind, "bodies", bodies, "stations", stations, "point", point, "rest", rest, ...
                  "stiffness", random_between (1, 1e9), "damping", random_pick ([0 0.1]));
endfunction

## by an angle that grows faster and faster, then steadily, or by a moment (N m) that ends
function joint = driven (scene, EI)
  ends = scene.breaks;
  if (rand () < 0.4)
    start = scene.bodies{1}.initial.phi;
    a = 0.3/scene.duration^2;
    value = @(t) start*[1 0 0] + a*[min(t, ends)^2/2 + ends*max(t - ends, 0), min(t, ends), t < ends];
    joint = struct ("kind", "angle", "bodies", 1, "stations", 0, "value", value);
  else
    moment = 0.02*EI/numel (scene.bodies);
    joint = struct ("kind", "moment", "bodies", numel (scene.bodies), "stations", 0, "value", @(t) moment*(t < ends));
  endif
endfunction

%!test # one to six rods by turns, open and closed, driven and pushed; springs of all sizes rest as it begins
%! scenes = arrayfun (@random_linkage, 1:120, "uniformoutput", false);
%! counts = cellfun (@(scene) numel (scene.bodies), scenes);
%! assert (counts(1:6), 1:6);
%! closed = cellfun (@(scene) sum (cellfun (@(joint) strcmp (joint.kind, "revolute"), scene.joints)), scenes) > counts;
%! assert (mean (closed(counts > 2)), 0.5, 0.15); assert (any (closed(counts < 3)), false);
%! has = @(kind) cellfun (@(scene) any (cellfun (@(joint) strcmp (joint.kind, kind), scene.joints)), scenes);
%! assert (mean (has ("angle")), 0.4, 0.15); assert (has ("moment"), ! has ("angle"));
%! all_joints = cellfun (@(scene) scene.joints, scenes, "uniformoutput", false);
%! stiff = cellfun (@(joint) field_or (joint, "stiffness", NaN), vertcat (all_joints{:}));
%! assert_spans (stiff(isfinite (stiff)), 1, 1e9);
%! for k = [2 3 4 5 6]
%!   scene = check_mechanism (scenes{k});
%!   system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, zeros (1, k))));
%!   start = assemble_mechanism (scene, system.mechanism, system);
%!   springs = system.at (0, start.q, start.v).springs;
%!   assert (abs (springs.tension) < 1e-6*max (springs.stiffness, 1));
%! endfor
%!test # the same seed gives the same, and angles have the rates that they state
%! assert (random_linkage (5).bodies{3}.rod, random_linkage (5).bodies{3}.rod);
%! scene = random_linkage (find (arrayfun (@(k) strcmp (random_linkage (k).joints{end}.kind, "angle"), 1:20), 1));
%! value = scene.joints{end}.value;
%! for t = scene.breaks*[0.5 1.5]
%!   assert ((value (t + 1e-5) - value (t - 1e-5))(1:2)/2e-5, value (t)(2:3), 1e-7);
%! endfor
