## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} in_pieces (@var{scene}, @var{count})
## A checked @var{scene} of bodies (see @code{check_mechanism}) whose straight rods are @var{count} pieces each, of one
## length and welded together: each bends less in its own frame, so that what second-order foreshortening drops falls
## (substructures; Wu and Haug, IJNME 26, 1988).  A joint is on the piece that has its station, a tip mass on the last
## one; the pieces are named "body 1, piece 2", the welds come after the scene's joints.  Amplitudes that a rod starts
## with are an error.
## @end deftypefn

function scene = in_pieces (scene, count)
  count = double (count);
  if (count == 1)
    return;
  endif
  bodies = struct ([]);
  welds = {};
  for k = 1:numel (scene.bodies)
    first(k) = numel (bodies) + 1;
    bodies = [bodies, pieces_of(scene.bodies(k), count)];
    for n = first(k) + 1:numel (bodies)
      welds{end+1} = struct ("kind", "weld", "name", ["weld of " bodies(n).name], "bodies", [n-1, n], ...
                             "stations", [bodies(n).rod.length, 0]);
    endfor
  endfor
  for k = 1:numel (scene.joints)
    for side = find (scene.joints(k).bodies > 0)
      n = first(scene.joints(k).bodies(side));
      last = [first, numel(bodies) + 1](scene.joints(k).bodies(side) + 1) - 1;
      [piece, scene.joints(k).stations(side)] = piece_at (scene.joints(k).stations(side), bodies(n).rod.length, last - n);
      scene.joints(k).bodies(side) = n + piece;
    endfor
  endfor
  scene.bodies = bodies;
  welds = with_values (check_joints (welds, bodies), bodies);
  if (isempty (scene.joints))
    scene.joints = welds;
  elseif (! isempty (welds))
    scene.joints = [scene.joints(:).', welds];
  endif
endfunction

## how many pieces before the one that has a station, and where on it: at its ends without rounding
function [piece, station] = piece_at (station, length, last)
  pieces = station/length;
  if (abs (pieces - round (pieces)) < 1e-9)
    pieces = round (pieces);
  endif
  piece = min (floor (pieces), last);
  station = (pieces - piece)*length;
endfunction

function pieces = pieces_of (body, count)
  pieces = body;
  if (! isempty (body.rod.curvature))
    return;
  elseif (any (cellfun (@(name) any (body.initial.(name)), {"V1", "V2", "V1_dot", "V2_dot"})))
    scene_error ("%s starts with amplitudes of its modes: in %d pieces it has others, and takes none", body.name, count);
  endif
  body.rod.length /= count;
  pieces = repmat (setfield (body, "tip_mass", 0), 1, count);
  pieces(end).tip_mass = body.tip_mass;
  for n = 1:count
    pieces(n).name = sprintf ("%s, piece %d", body.name, n);
    if (n > 1)  # where the weld puts it
      [pieces(n).initial.x, pieces(n).initial.y, pieces(n).initial.x_dot, pieces(n).initial.y_dot] = deal ([]);
    endif
  endfor
endfunction

%!function scene = two_rods ()   # a straight one with a weight at its tip, and an arc that hangs on its middle
%!  rod = struct ("length", 2, "EA", 1e4, "EI", 1, "rhoA", 1, "half_height", 0.01);
%!  scene.bodies = {struct("name", "boom", "rod", rod, "tip_mass", 3, "initial", struct ("x", 1, "phi_dot", 2))
%!                  struct("rod", setfield (rod, "curvature", 0.5))};
%!  scene.joints = {struct("kind", "revolute", "bodies", [2 1], "stations", [2 1])
%!                  struct("kind", "force", "bodies", 1, "stations", 1.7, "value", [0 1])};
%!  scene.duration = 1;
%!endfunction
%!test # which piece has what
%! scene = check_mechanism (setfield (two_rods (), "pieces", 4));
%! assert ({scene.bodies.name}(3:5), {"boom, piece 3", "boom, piece 4", "body 2"});
%! assert (arrayfun (@(body) body.rod.length, scene.bodies), [0.5 0.5 0.5 0.5 2]);
%! assert ([scene.bodies.tip_mass], [0 0 0 3 0]);
%! assert (scene.bodies(1).initial.x, 1); assert (isempty (scene.bodies(2).initial.x));
%! assert (arrayfun (@(body) body.initial.phi_dot, scene.bodies), [2 2 2 2 0]);
%! assert ({scene.joints.kind}, {"revolute", "force", "weld", "weld", "weld"});
%! assert (vertcat (scene.joints.bodies), [5 3; 4 0; 1 2; 2 3; 3 4]);
%! assert (vertcat (scene.joints.stations), [2 0; 0.2 0; 0.5 0; 0.5 0; 0.5 0], 1e-15);
%!test # what holds a tip, and an inner end, is there to the last bit, whatever the number
%! scene = two_rods ();
%! scene.bodies{1}.rod.length = 1;
%! for count = [3 5 6 7 10]
%!   scene.joints = {struct("kind", "weld", "bodies", [1 2], "stations", [1 0])
%!                   struct("kind", "moment", "bodies", 1, "stations", 2/count, "value", 1)};
%!   joints = check_mechanism (setfield (scene, "pieces", int8 (count))).joints;
%!   assert (joints(1).stations(1) == 1/count); assert (joints(1).bodies, [count, count + 1]);
%!   assert (joints(2).stations(1), 0); assert (joints(2).bodies(1), 3);
%! endfor
%!test # what has no straight rods, or no joints
%! arc = setfield (arc_pendulum (), "pieces", 3);
%! assert (numel (check_mechanism (arc).bodies), 1);
%! scene = rmfield (two_rods (), "joints");
%! assert ({check_mechanism(setfield (scene, "pieces", 2)).joints.name}, {"weld of boom, piece 2"});
%!test # a rod in a hub is at first where that is, in pieces, too
%! scene = struct ("rod", two_rods ().bodies{1}.rod, "duration", 0.1, "rotation", @(t) [1+3*t, 3, 0], "gravity", 0);
%! scene.model.modes = [0 0];
%! whole = driver (scene, "output", "");
%! pieces = driver (scene, "output", "", "pieces", 2);
%! assert (pieces.history.bodies(2).tip_x, whole.history.tip_x, 1e-8);
%!test # a rigid rod swings as its four pieces do
%! scene = struct ("rod", two_rods ().bodies{1}.rod, "duration", 0.5, "frames_per_second", 10, "tip_mass", 2);
%! [scene.model.modes, scene.solver.tolerance, scene.initial.phi_dot] = deal ([0 0], 1e-9, 3);
%! whole = driver (scene, "output", "");
%! pieces = driver (scene, "output", "", "pieces", 4);
%! assert (pieces.history.bodies(4).tip_y, whole.history.tip_y, 1e-8);
%! assert (range (whole.history.tip_y) > 1);
%!error <pieces is 2.5000: it takes whole number from 1 to 50, pieces of each straight rod>
%! check_mechanism (setfield (two_rods (), "pieces", 2.5));
%!error <pieces is 51: it takes whole number> check_mechanism (setfield (two_rods (), "pieces", 51));
%!error <boom starts with amplitudes of its modes: in 3 pieces it has others, and takes none>
%! scene = two_rods ();
%! scene.bodies{1}.initial.V2 = 0.1;
%! check_mechanism (setfield (scene, "pieces", 3));
