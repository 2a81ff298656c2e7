## -*- texinfo -*-
## @deftypefn {} {@var{found} =} campbell (@var{scene}, @var{option}, @var{value}, @dots{})
## Campbell's diagram of one rod, in a hub or free to turn about its hinge, of a rod on a surface in a hub, or of a
## mechanism whose bodies all turn about the point that holds them (see @code{rotation_centre}): the frequencies of
## vibrations about steady rotation against the angular velocity, without weight and loads.  Arguments as for
## @code{driver}, and "speeds": angular velocities (rad/s, rising; default: 13 from 0 to what the scene's hub
## reaches).  What is taken without stated modes is in @code{steady_rod}, @code{steady_surface} and
## @code{steady_mechanism}, with foreshortening: without it a rod loses its stiffness as it turns.
##
## Branches are the six slowest of what vibrates at the first speed, followed by the modal assurance criterion of
## complex modes (Allemang and Brown 1982) in steps of a fiftieth of the range at most.  Leaves campbell.csv,
## campbell.svg and campbell.png.  @var{found} is a struct of speeds (1-by-m), f (Hz, a row a branch), growth (1/s,
## likewise, of what is unstable) and mac (likewise, the least criterion of the steps since the speed before).
## @end deftypefn

function found = campbell (scene = "spin_up", varargin)
  [speeds, options] = taken_option (varargin, "speeds", [], @are_rising, "rising angular velocities in rad/s");
  [scene, kind, output] = study_scene (scene, options);
  if (isempty (kind.turning))
    scene_error ("campbell takes rods in a hub or at a hinge, not a scene of the kind \"%s\"", kind.name);
  endif
  turning = kind.turning (scene);
  if (isempty (speeds))
    speeds = linspace (0, highest_speed (turning.speed), 13);
  endif
  result = branches (turning.about, speeds, 6);
  for k = 1:numel (speeds)
    printf ("  %10.5g rad/s: %s Hz, MAC at least %.3f\n", speeds(k), sprintf ("%11.7g", result.f(:,k)), ...
            min (result.mac(:,k)));
  endfor
  if (any (result.growth(:) > 0))
    say ("warning: from %.4g rad/s on the rod is unstable", speeds(find (any (result.growth > 0, 1), 1)));
  endif
  publish_study (output, {"campbell.csv"}, {"campbell.svg", "campbell.png"}, ...
                 @(aside) write_campbell (result, aside), @(scratch) draw_campbell (result, scene.title, scratch));
  if (nargout > 0)
    found = result;
  endif
endfunction

function speed = highest_speed (speed)
  if (isnan (speed))
    scene_error ("the scene has no rotation: state the speeds, SPEEDS=0:1:12 in rad/s");
  elseif (speed == 0)
    scene_error ("the scene's hub does not turn: state the speeds, SPEEDS=0:1:12 in rad/s");
  endif
endfunction

function found = branches (about, speeds, count)
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
      order = find (max (modes.omega, modes.rate) > 1e-7*max (modes.omega))(1:min (end, count));  # not what is rigid
      mac = ones (numel (order), 1);
    else
      [order, mac] = followed (shapes, last, linear.mass);
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

## steps of a fiftieth of the range at most, so that branches are the same from one to the next
function speeds = fine_steps (speeds)
  for k = numel (speeds)-1:-1:1
    parts = ceil (50*(speeds(k+1) - speeds(k))/speeds(end));
    speeds = [speeds(1:k), speeds(k) + (1:parts-1)/parts*(speeds(k+1) - speeds(k)), speeds(k+1:end)];
  endfor
endfunction

## which of the shapes are those of the speed before, and by what criterion (a column)
function [order, best] = followed (shapes, last, M)
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

%!error <no steady rotation: a rod on a surface turns in a hub> campbell ("bowl", "speeds", [0 1])
%!error <the scene has no rotation: state the speeds> campbell ("swing")
%!error <no steady rotation: .* holds a body to another point of the ground> campbell ("four_bar", "speeds", [0 1])
%!error <speeds is -1: it takes rising angular velocities> campbell ("spin_up", "speeds", -1)

%!function found = unit_rod (speeds, varargin)   # of unit length, mass and EI
%!  scene.rod = struct ("length", 1, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.005);
%!  scene.duration = 1;
%!  for k = 1:2:numel (varargin)
%!    scene = setfield (scene, strsplit (varargin{k}, "."){:}, varargin{k+1});
%!  endfor
%!  found = found_of (scene, speeds);
%!endfunction
%!function found = found_of (scene, speeds)
%!  folder = tempname (); confirm_recursive_rmdir (false, "local");
%!  unwind_protect
%!    evalc ("found = campbell (scene, 'speeds', speeds, 'output', folder);");
%!    table = csvread (fullfile (folder, "campbell.csv"), 1, 0);
%!    assert (table(:,2), found.f(1,:).', 1e-15); assert (table(:,end), found.mac(end,:).', 1e-15);
%!    assert (stat (fullfile (folder, "campbell.png")).size > 10000);
%!  unwind_protect_cleanup
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test # in a hub: the table of Wright, Smith, Thresher and Wang (1982), flapping frequencies, to its four decimals
%! flapping = [3.5160 22.0345 61.6972;  3.6817 22.1810 61.8418;  4.1373 22.6149 62.2732;  4.7973 23.3203 62.9850
%!             5.5850 24.2733 63.9668;  6.4495 25.4461 65.2050;  7.3604 26.8091 66.6839;  8.2996 28.3341 68.3860
%!             9.2568 29.9954 70.2930; 10.2257 31.7705 72.3867; 11.2023 33.6404 74.6493; 12.1843 35.5890 77.0638
%!             13.1702 37.6031 79.6145].';
%! found = unit_rod (0:12, "rod.EA", 1e8, "rotation", @(t) [0*t; 0*t; 0*t]);
%! assert (sqrt ((2*pi*found.f(1:3,:)).^2 + found.speeds.^2), flapping, 7e-5);
%! assert (found.mac > 0.999); assert (found.growth, zeros (6, 13));
%!test # the slowest is not lost beside what is 10^7 times as fast
%! found = unit_rod ([0 1], "rod.EA", 1e10, "rotation", @(t) [0*t; 0*t; 0*t]);
%! assert (2*pi*found.f(1,1), 1.87510407^2, 1e-5);
%!test # at a hinge, to four decimals of the power series that has the table's
%! found = unit_rod (0:12, "rod.EA", 1e8);
%! for speed = 0:12
%!   expected = turning_beam (speed, 4, "hinge")(2:4).';
%!   assert (2*pi*found.f(1:3,speed+1), expected, 5e-5*[1; 1; 1.2]);
%! endfor
%! assert (found.mac > 0.999);
%!test # the third bending mode and the first along the rod veer, a quarter of a period apart: no branch jumps
%! found = unit_rod (8:11, "rod.EA", 2000, "rotation", @(t) [0*t; 0*t; 0*t]);
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
%! found = found_of (scene, 0.5:0.5:4);
%! swing = find (abs (2*pi*found.f(:,1) - 0.5*sqrt (3)) < 1e-6);
%! bends = find (abs (2*pi*found.f(:,1) - turning_beam (0.5, 1, "clamped")) < 1e-4);
%! assert (2*pi*found.f(swing,:), found.speeds*sqrt (3), 1e-6);
%! assert (numel (bends), 1);
%! assert (2*pi*found.f(bends,end), turning_beam (4, 1, "clamped"), 5e-4); assert (found.mac > 0.999);
%! assert (sign (found.f(swing,[1 end]) - found.f(bends,[1 end])), [-1 1]);
