## -*- texinfo -*-
## @deftypefn {} {@var{found} =} campbell (@var{scene}, @var{option}, @var{value}, @dots{})
## Campbell's diagram of one rod, in a hub or free to turn about its hinge: the frequencies of its vibrations about
## steady rotation against the angular velocity, without weight and loads.  Arguments as for @code{driver}, and
## "speeds": angular velocities (rad/s, rising; default: 13 from 0 to what the scene's hub reaches).  Without stated
## modes it takes 30 bending modes and 30 longitudinal ones, with foreshortening: without it a rod loses its stiffness
## as it turns.
##
## Branches are followed by the modal assurance criterion (Allemang and Brown 1982) in steps of a fiftieth of the range
## at most.  Leaves campbell.csv, campbell.svg and campbell.png.  @var{found} is a struct of speeds (1-by-m), f (Hz, a
## row a branch), growth (1/s, likewise, of what is unstable) and mac, the least of each step's criteria.
## @end deftypefn

function found = campbell (scene = "spin_up", varargin)
  [speeds, options] = taken_option (varargin, "speeds", [], @are_rising, "rising angular velocities in rad/s");
  [scene, kind, output] = study_scene (scene, options);
  if (! strcmp (kind.name, "rod"))
    scene_error ("campbell takes one rod in a hub or at a hinge, not a scene of the kind \"%s\"", kind.name);
  endif
  if (isempty (speeds))
    speeds = linspace (0, highest_speed (scene), 13);
  endif
  result = branches (kind, turning_scene (scene), speeds, 6);
  for k = 1:numel (speeds)
    printf ("  %10.5g rad/s: %s Hz, MAC at least %.3f\n", speeds(k), sprintf ("%11.7g", result.f(:,k)), result.mac(k));
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

function speed = highest_speed (scene)
  if (isempty (scene.rotation))
    scene_error ("the scene has no rotation: state the speeds, SPEEDS=0:1:12 in rad/s");
  endif
  speed = max (abs (at_times (scene.rotation, linspace (0, scene.duration, 1001))(2,:)));
  if (speed == 0)
    scene_error ("the scene's hub does not turn: state the speeds, SPEEDS=0:1:12 in rad/s");
  endif
endfunction

## weightless, unloaded, and with a rich model where none is stated
function scene = turning_scene (scene)
  [scene.gravity, scene.moment, scene.moment_breaks, scene.force, scene.joints] = deal (0, @(t) 0*t, [], [], []);
  for name = {"phi_dot", "V1", "V2", "V1_dot", "V2_dot"}
    scene.initial.(name{1}) = 0;
  endfor
endfunction

function found = branches (kind, scene, speeds, count)
  rung = kind.stated (scene);
  if (isempty (rung))
    rung = kind.far_richer (scene, []);
  endif
  model = kind.build (scene, rung);
  q = [];
  last = [];
  found = struct ("speeds", speeds, "f", [], "growth", [], "mac", []);
  for speed = fine_steps (speeds)
    [linear, q] = about_rotation (kind, scene, model, speed, q);
    modes = vibrations (linear);
    bending = find (max (modes.omega, modes.rate) > 1e-6*max (modes.omega));  # and not the rigid rotation
    shapes = modes.shape(:,bending);
    [order, mac] = followed (shapes, last, linear.M, count);
    last = shapes(:,order);
    if (any (speed == speeds))
      found.f(:,end+1) = modes.omega(bending(order)).'/(2*pi);
      found.growth(:,end+1) = modes.rate(bending(order)).';
      found.mac(end+1) = mac;
    endif
  endfor
endfunction

## steps of a fiftieth of the range at most, so that branches are the same from one to the next
function speeds = fine_steps (speeds)
  for k = numel (speeds)-1:-1:1
    parts = ceil (50*(speeds(k+1) - speeds(k))/speeds(end));
    speeds = [speeds(1:k), speeds(k) + (1:parts-1)/parts*(speeds(k+1) - speeds(k)), speeds(k+1:end)];
  endfor
endfunction

## which of the shapes are those of the speed before
function [order, least] = followed (shapes, last, M, count)
  order = 1:min (count, columns (shapes));
  least = 1;
  if (isempty (last))
    return;
  endif
  mac = (last.'*M*shapes).^2./(sum (last.*(M*last), 1).'*sum (shapes.*(M*shapes), 1));
  for pass = 1:rows (mac)
    [best, at] = max (mac(:));
    [branch, mode] = ind2sub (size (mac), at);
    order(branch) = mode;
    least = min (least, best);
    mac(branch,:) = mac(:,mode) = -1;
  endfor
endfunction

%!error <takes one rod in a hub or at a hinge, not a scene of the kind "surface"> campbell ("bowl", "speeds", [0 1])
%!error <the scene has no rotation: state the speeds> campbell ("swing")
%!error <speeds is -1: it takes rising angular velocities> campbell ("spin_up", "speeds", -1)

%!function found = unit_rod (speeds, varargin)   # of unit length, mass and EI
%!  scene.rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.005);
%!  scene.duration = 1;
%!  for k = 1:2:numel (varargin)
%!    scene.(varargin{k}) = varargin{k+1};
%!  endfor
%!  folder = tempname (); confirm_recursive_rmdir (false, "local");
%!  unwind_protect
%!    evalc ("found = campbell (scene, 'speeds', speeds, 'output', folder);");
%!    assert (csvread (fullfile (folder, "campbell.csv"), 1, 0)(:,2), found.f(1,:).', 1e-15);
%!    assert (stat (fullfile (folder, "campbell.png")).size > 10000);
%!  unwind_protect_cleanup
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test # in a hub: Wright, Smith, Thresher and Wang (1982), flapping frequencies squared less the speed's square
%! flapping = [3.5160 22.0345; 4.1373 22.6149; 5.5850 24.2733; 9.2568 29.9954; 13.1702 37.6031].';
%! speeds = [0 2 4 8 12];
%! found = unit_rod (speeds, "rotation", @(t) [0*t; 0*t; 0*t]);
%! assert (2*pi*found.f(1:2,:), sqrt (flapping.^2 - speeds.^2), 1e-3*flapping);
%! assert (found.mac > 0.9); assert (found.growth, zeros (6, 5));
%!test # at a hinge, by collocation of the rotating beam
%! found = unit_rod ([0 4 12]);
%! for k = 1:3
%!   assert (2*pi*found.f(1:3,k), rotating_beam (found.speeds(k), 3), -1e-3);
%! endfor
