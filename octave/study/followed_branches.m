## -*- texinfo -*-
## @deftypefn {} {@var{found} =} followed_branches (@var{about}, @var{speeds}, @var{count})
## The branches of Campbell's diagram: of what vibrates at the first of the @var{speeds} (1-by-m, rad/s, rising) the
## @var{count} slowest, each followed by the modal assurance criterion of complex modes (Allemang and Brown 1982) in
## steps of a fiftieth of the last speed at most.  [linear, q] = @var{about} (speed, q) are the linear equations (see
## @code{vibrations}) about the steady rotation, with a basis and the mass by which shapes = basis*vectors are compared,
## and where it is, near the q of the speed before ([] at the first).
##
## @var{found}: a struct of speeds, f (Hz, a row a branch), growth (1/s, likewise, of what is unstable) and mac
## (likewise, the least criterion of the steps since the speed before).
## @end deftypefn

function found = followed_branches (about, speeds, count)
  q = [];
  last = [];
  least = 1;
  found = struct ("speeds", speeds, "f", [], "growth", [], "mac", []);
  for speed = fine_steps (speeds)
    show_progress (sprintf ("%.4g rad/s", speed));
    [linear, q] = about (speed, q);
    modes = vibrations (linear);
    shapes = linear.basis*modes.vector;
    if (isempty (last))
      order = find (max (modes.omega, modes.rate) > 0)(1:min (end, count));  # not what nothing brings back
      mac = ones (numel (order), 1);
    else
      [order, mac] = most_alike (shapes, last, linear.mass);
    endif
    last = shapes(:,order);
    least = min (least, mac);
    if (any (speed == speeds))
      found.f(:,end+1) = modes.omega(order).'/(2*pi);
      found.growth(:,end+1) = modes.rate(order).';
      found.mac(:,end+1) = least;
      least = 1;
    endif
  endfor
  show_progress ("");
endfunction

## steps of a fiftieth of the last one at most, so that branches are the same from one to the next
function speeds = fine_steps (speeds)
  for k = numel (speeds)-1:-1:1
    parts = ceil (50*(speeds(k+1) - speeds(k))/speeds(end));
    speeds = [speeds(1:k), speeds(k) + (1:parts-1)/parts*(speeds(k+1) - speeds(k)), speeds(k+1:end)];
  endfor
endfunction

## which of the shapes are those of the speed before, and by what criterion (a column)
function [order, best] = most_alike (shapes, last, M)
  energy = @(vectors) real (sum (conj (vectors).*(M*vectors), 1));
  mac = abs (last'*M*shapes).^2./(energy (last).'*energy (shapes));
  order = zeros (1, rows (mac));
  best = zeros (rows (mac), 1);
  for pass = 1:rows (mac)
    [largest, at] = max (mac(:));
    [branch, mode] = ind2sub (size (mac), at);
    order(branch) = mode;
    best(branch) = largest;
    mac(branch,:) = mac(:,mode) = -1;
  endfor
endfunction

%!function [linear, q] = oscillators (speed, q, coupling)
%!  ## one that turns stiffer with the speed, one that does not, and one that is not held
%!  if (! isempty (q))  # it is asked in small steps, and told where it was
%!    assert (speed - q <= 10/50 + 1e-12); assert (speed > q);
%!  endif
%!  q = speed;
%!  K = blkdiag ([4 + speed^2, coupling; coupling, 29], 0);
%!  linear = struct ("M", eye (3), "C", zeros (3), "K", K, "basis", [2 0 0; 0 1 0; 1 1 1], "mass", diag ([1 2 0]));
%!endfunction
%!test # two oscillators cross where they do not feel each other, and veer where they do
%! found = followed_branches (@(speed, q) oscillators (speed, q, 0), 0:10, 6);
%! assert (2*pi*found.f, [sqrt(4 + (0:10).^2); sqrt(29)*ones(1, 11)], 1e-9);
%! assert (found.mac, ones (2, 11), 1e-9); assert (found.growth, zeros (2, 11)); assert (found.speeds, 0:10);
%! found = followed_branches (@(speed, q) oscillators (speed, q, 5), 0:10, 1);
%! assert ((2*pi*found.f([1 end])).^2, [33/2, 133/2] - hypot ([25/2, 75/2], 5), 1e-9);
%! assert (found.mac(6) > 0.95); assert (found.mac(6) < 0.995); assert (found.mac(11) > 0.999);
%!function found = followed (scene, speeds)
%!  scene = checked_scene (scene, {});
%!  found = followed_branches (kind_of (scene).turning (scene).about, speeds, 6);
%!endfunction
%!test # the slowest is not lost beside what is 10^7 times as fast
%! found = followed (unit_rod ("rod.EA", 1e10, "rotation", @(t) [0*t; 0*t; 0*t]), [0 1]);
%! assert (2*pi*found.f(1,1), 1.87510407^2, 1e-5);
%!test # the third bending mode and the first along the rod veer, a quarter of a period apart: no branch jumps
%! found = followed (unit_rod ("rod.EA", 2000, "rotation", @(t) [0*t; 0*t; 0*t]), 8:11);
%! assert (found.mac > 0.95); assert (any (found.mac(3:4,:)(:) < 0.99));
%! apart = diff (2*pi*found.f(3:4,:));
%! assert (apart > 0.8); assert (apart([2 3]) < 0.8*apart([1 4]));
%!test # two rods on a rigid hub: the swing of the one that is pinned to the rim crosses the bending of the clamped one
%! rod = struct ("rod", struct ("length", 1, "EA", 1e8, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.001), ...
%!               "model", struct ("modes", "auto", "energy", "uniaxial"));
%! hub = setfield (setfield (rod, "rod", "length", 2), "model", "modes", [0 0]);
%! at = @(kind, bodies, stations) struct ("kind", kind, "bodies", bodies, "stations", stations);
%! scene = struct ("bodies", {{hub, rod, setfield(rod, "model", "modes", [0 0])}}, "duration", 1, "joints", ...
%!                 {{at("revolute", 1, 0), at("angle", 1, 0), at("weld", [1 2], [0 0]), at("revolute", [1 3], [2 0])}});
%! found = followed (scene, 0.5:0.5:4);
%! swing = find (abs (2*pi*found.f(:,1) - 0.5*sqrt (3)) < 1e-6);
%! bends = find (abs (2*pi*found.f(:,1) - turning_beam (0.5, 1, "clamped")) < 1e-4);
%! assert (2*pi*found.f(swing,:), found.speeds*sqrt (3), 1e-6);
%! assert (numel (bends), 1);
%! assert (2*pi*found.f(bends,end), turning_beam (4, 1, "clamped"), 5e-4); assert (found.mac > 0.999);
%! assert (sign (found.f(swing,[1 end]) - found.f(bends,[1 end])), [-1 1]);
%!test # nor beside a hub of near to infinite stiffness
%! rod = @(EI, l) struct ("length", l, "EA", 1e9, "EI", EI, "rhoA", 0.7, "rhoI", 0);
%! model = struct ("modes", "auto", "stiffening", "exact");
%! at = @(kind, bodies, stations) struct ("kind", kind, "bodies", bodies, "stations", stations);
%! scene = struct ("bodies", {{struct("rod", rod (1e9, 0.6), "model", model), ...
%!                             struct("rod", rod (20, 1.3), "model", model, "tip_mass", 0.4)}}, "duration", 1, ...
%!                 "joints", {{at("revolute", 1, 0), at("angle", 1, 0), at("weld", [1 2], [0.6 0])}});
%! assert (2*pi*followed (scene, [0 1]).f(1:2,1), [6.65468; 53.9464], -1e-5);
