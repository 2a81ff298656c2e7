## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{v}] =} placed_bodies (@var{scene}, @var{mechanism})
## Coordinates and rates (n-by-1) that the scene's bodies state: a body without initial.x and initial.y is where its
## first joint with a body that has its place, or with the ground, puts its point, and one without initial.x_dot and
## initial.y_dot moves as that point does.
## @end deftypefn

function [q, v] = placed_bodies (scene, mechanism)
  count = numel (scene.bodies);
  place = NaN (count, 2);
  velocity = NaN (count, 2);
  for k = 1:count
    initial = scene.bodies(k).initial;
    if (! isempty (initial.x) || ! isempty (initial.y))
      place(k,:) = [[initial.x, 0](1), [initial.y, 0](1)];
      velocity(k,:) = 0;
    endif
    if (! isempty (initial.x_dot) || ! isempty (initial.y_dot))
      velocity(k,:) = [[initial.x_dot, 0](1), [initial.y_dot, 0](1)];
    endif
  endfor
  [place, velocity] = place_by_joints (scene, mechanism, place, velocity);
  q = v = zeros (mechanism.n, 1);
  for k = 1:count
    initial = scene.bodies(k).initial;
    index = index_of (mechanism, k);
    [V, V_dot] = amplitudes (initial, mechanism.models{k}.base, scene.bodies(k).name);
    q(index) = [V; initial.phi; place(k,:).'];
    v(index) = [V_dot; initial.phi_dot; velocity(k,:).'];
  endfor
endfunction

function [place, velocity] = place_by_joints (scene, mechanism, place, velocity)
  kinds = {"revolute", "weld", "position", "bushing"};
  at = @(body, station) point_of (scene.bodies(body).initial, mechanism.models{body}.base, station);
  do
    placed = sum (! isnan (place(:,1)));
    for joint = scene.joints(:).'
      if (! any (strcmp (joint.kind, kinds)))
        continue;
      endif
      for sides = [1 2; 2 1].'
        [mine, other] = deal (joint.bodies(sides(1)), joint.bodies(sides(2)));
        if (mine == 0 || ! isnan (place(mine,1)) || (other > 0 && isnan (place(other,1))))
          continue;
        endif
        [point, rate] = deal (joint.point(:).', [0 0]);
        if (other > 0)
          [point, rate] = at (other, joint.stations(sides(2)));
          [point, rate] = deal (point + place(other,:), rate + velocity(other,:));
        endif
        offset = joint.value (0)(1:min (end, 2),1:end*strcmp (joint.kind, "position"));
        if (! isempty (offset))
          [point, rate] = deal (point + (3 - 2*sides(1))*offset(1,:), rate + (3 - 2*sides(1))*offset(2,:));
        endif
        [from_O, rate_from_O] = at (mine, joint.stations(sides(1)));
        place(mine,:) = point - from_O;
        if (isnan (velocity(mine,1)))
          velocity(mine,:) = rate - rate_from_O;
        endif
      endfor
    endfor
  until (sum (! isnan (place(:,1))) == placed)
  place(isnan (place)) = 0;
  velocity(isnan (velocity)) = 0;
endfunction

## from O, of the undeformed rod
function [point, rate] = point_of (initial, base, station)
  [x_0, y_0] = undeformed_places (base, station);
  [x, y] = rod_centreline (initial.phi, x_0, y_0*0, y_0);
  point = [x, y];
  rate = initial.phi_dot*[-y, x];
endfunction

function [V, V_dot] = amplitudes (initial, base, name)
  numbers = {base.longitudinal, base.transversal};
  V = V_dot = [];
  for i = 1:2
    [N, all] = deal (sum (numbers{i} > 0), numel (numbers{i}));
    of = {sprintf("V%d", i), sprintf("V%d_dot", i)};
    for field = of
      given = initial.(field{1})(:);
      if (numel (given) > N)
        scene_error ("%s: initial.%s has %d amplitudes for %d modes", name, field{1}, numel (given), N);
      endif
      padded.(field{1}) = [given; zeros(all - numel (given), 1)];
    endfor
    V = [V; padded.(of{1})];
    V_dot = [V_dot; padded.(of{2})];
  endfor
endfunction

%!test # the second rod hangs where the first one ends
%! [system, ~, scene] = sample_mechanism ([0 1]);
%! scene.bodies(1).initial.phi = pi/2;
%! q = placed_bodies (scene, system.mechanism);
%! assert (q(index_of (system.mechanism, 2)(end-1:end)), [0; 0.5], 1e-15);
%!test # what flies free, or hangs on a bushing, keeps the velocity that is stated, wherever its place comes from
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0]), "initial", struct ("y_dot", 0.1))};
%! [scene.gravity, scene.duration] = deal (0, 0.1);
%! scene.joints = {struct("kind", "moment", "bodies", 1, "stations", 0)};
%! assert (driver (scene, "output", "").history.bodies.y(end), 0.01, 1e-9);
%! scene.joints = {struct("kind", "bushing", "bodies", 1, "stations", 0.5, "point", [2 0], "stiffness", 4)};
%! scene = check_mechanism (scene);
%! [q, v] = placed_bodies (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! assert (q, [0; 1.5; 0], 1e-15); assert (v, [0; 0; 0.1]);
%!error <body 1: initial.V2 has 2 amplitudes for 1 modes>
%! [system, ~, scene] = sample_mechanism ([0 1]); scene.bodies(1).initial.V2 = [1 2];
%! placed_bodies (scene, system.mechanism);
