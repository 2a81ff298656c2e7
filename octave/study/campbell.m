## -*- texinfo -*-
## @deftypefn {} {@var{found} =} campbell (@var{scene}, @var{option}, @var{value}, @dots{})
## Campbell's diagram of one rod, in a hub or free to turn about its hinge, of a rod on a surface in a hub, or of a
## mechanism whose bodies all turn about the point that holds them (see @code{rotation_centre}): the frequencies of
## vibrations about steady rotation against the angular velocity, without weight and loads.  Arguments as for
## @code{driver}, and "speeds": angular velocities (rad/s, rising; default: 13 from 0 to what the scene's hub
## reaches).  What is taken without stated modes is in @code{steady_rod}, @code{steady_surface} and
## @code{steady_mechanism}, with foreshortening: without it a rod loses its stiffness as it turns.
##
## Branches are the six slowest of what vibrates at the first speed, followed from speed to speed; @var{found} is the
## struct of @code{followed_branches}.  Leaves campbell.csv, campbell.svg and campbell.png.
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
  result = followed_branches (turning.about, speeds, 6);
  if (isempty (result.f))
    scene_error ("nothing vibrates at %g rad/s: state model.modes that bend, [0 3] say", speeds(1));
  endif
  for k = 1:numel (speeds)
    say ("  %10.5g rad/s: %s Hz, MAC at least %.3f", speeds(k), sprintf ("%11.7g", result.f(:,k)), ...
         min (result.mac(:,k)));
  endfor
  if (any (result.growth(:) > 0))
    say ("warning: from %.4g rad/s on the rod is unstable", speeds(find (any (result.growth > 0, 1), 1)));
  endif
  if (isfield (turning, "richer"))
    say_change (turning, speeds(end));
  endif
  publish_study (output, {"campbell.csv"}, {"campbell.svg", "campbell.png"}, ...
                 @(aside) write_campbell (result, aside), @(scratch) draw_campbell (result, scene.title, scratch));
  if (nargout > 0)
    found = result;
  endif
endfunction

## of the slowest six, by twice as many base functions
function say_change (turning, speed)
  try
    [omega, better] = deal (slowest (turning.about (speed, [])), slowest (turning.richer (speed, [])));
  catch err
    rethrow_others (err, "toolchain:scene");
    say ("  at %g rad/s twice as many base functions have no steady rotation from what is undeformed", speed);
    return;
  end_try_catch
  count = min (numel (omega), numel (better));
  change = max ([0, abs(better(1:count)./omega(1:count) - 1)]);
  text = sprintf ("twice as many base functions change the slowest by %.1g at %g rad/s", change, speed);
  if (change > 1e-3)
    say ("warning: %s: EXACT=yes, or more model.modes with model.stiffening = \"exact\", has them better", text);
  else
    say ("  %s", text);
  endif
endfunction

function omega = slowest (linear)
  omega = vibrations (linear).omega;
  omega = omega(omega > 0)(1:min (end, 6));
endfunction

function speed = highest_speed (speed)
  if (isnan (speed))
    scene_error ("the scene has no rotation: state the speeds, SPEEDS=0:1:12 in rad/s");
  elseif (speed == 0)
    scene_error ("the scene's hub does not turn: state the speeds, SPEEDS=0:1:12 in rad/s");
  endif
endfunction

%!error <nothing vibrates at 1 rad/s: state model.modes that bend> campbell ("swing", "modes", [0 0], "speeds", [1 5])
%!error <nothing vibrates at 0 rad/s: state model.modes> campbell ("spin_up", "modes", [0 0])
%!error <no steady rotation: a rod on a surface turns in a hub> campbell ("bowl", "speeds", [0 1])
%!error <the scene has no rotation: state the speeds> campbell ("swing")
%!error <no steady rotation: .* holds a body to another point of the ground> campbell ("four_bar", "speeds", [0 1])
%!error <speeds is -1: it takes rising angular velocities> campbell ("spin_up", "speeds", -1)

%!function found = found_of (scene, speeds)
%!  [folder, gone] = scratch_folder ();
%!  evalc ("found = campbell (scene, 'speeds', speeds, 'output', folder);");
%!  table = csvread (fullfile (folder, "campbell.csv"), 1, 0);
%!  assert (table(:,2), found.f(1,:).', 1e-15); assert (table(:,end), found.mac(end,:).', 1e-15);
%!  assert (stat (fullfile (folder, "campbell.png")).size > 10000);
%!endfunction
%!test # in a hub: the table of Wright, Smith, Thresher and Wang (1982), flapping frequencies, to its four decimals
%! flapping = [3.5160 22.0345 61.6972;  3.6817 22.1810 61.8418;  4.1373 22.6149 62.2732;  4.7973 23.3203 62.9850
%!             5.5850 24.2733 63.9668;  6.4495 25.4461 65.2050;  7.3604 26.8091 66.6839;  8.2996 28.3341 68.3860
%!             9.2568 29.9954 70.2930; 10.2257 31.7705 72.3867; 11.2023 33.6404 74.6493; 12.1843 35.5890 77.0638
%!             13.1702 37.6031 79.6145].';
%! found = found_of (unit_rod ("rod.EA", 1e8, "rotation", @(t) [0*t; 0*t; 0*t]), 0:12);
%! assert (sqrt ((2*pi*found.f(1:3,:)).^2 + found.speeds.^2), flapping, 7e-5);
%! assert (found.mac > 0.999); assert (found.growth, zeros (6, 13));
%!test # at a hinge, to four decimals of the power series that has the table's
%! found = found_of (unit_rod ("rod.EA", 1e8), 0:12);
%! for speed = 0:12
%!   expected = turning_beam (speed, 4, "hinge")(2:4).';
%!   assert (2*pi*found.f(1:3,speed+1), expected, 5e-5*[1; 1; 1.2]);
%! endfor
%! assert (found.mac > 0.999);
%!test # free at its hinge it turns from the first speed on: that neither grows nor is a branch
%! for first = [0 20]
%!   found = found_of (swing (), [first 1000]);
%!   assert (found.growth, zeros (size (found.f))); assert (found.f(1,1), 676.6, 0.1);
%! endfor
%!test # a rod with a mass at its tip on a hub: sines say that they are too few, polynomials on a rigid one are enough
%! rod = @(EI, l) struct ("length", l, "EA", 1e9, "EI", EI, "rhoA", 0.7, "rhoI", 0);
%! at = @(kind, bodies, stations) struct ("kind", kind, "bodies", bodies, "stations", stations);
%! scene = struct ("bodies", {{struct("rod", rod (1e9, 0.6)), struct("rod", rod (20, 1.3), "tip_mass", 0.4)}}, ...
%!                 "joints", {{at("revolute", 1, 0), at("angle", 1, 0), at("weld", [1 2], [0.6 0])}}, "duration", 1);
%! said = evalc ("campbell (scene, 'speeds', [30 60], 'output', '');");
%! assert (regexp (said, 'warning: twice as many base functions .* at 60 rad/s: EXACT=yes') > 0);
%! scene.bodies{1}.model.modes = [0 0];
%! said = evalc ("campbell (scene, 'speeds', [30 60], 'exact', true, 'output', '');");
%! assert (isempty (strfind (said, "warning"))); assert (regexp (said, 'change the slowest by \S+ at 60 rad/s') > 0);
