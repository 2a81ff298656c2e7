## -*- texinfo -*-
## @deftypefn {} {@var{history} =} unheld_mechanisms (@var{joints})
## The motion of a rigid rod of 1 m and 2 kg that no constraint holds but what the @var{joints} (a cell array of
## springs, bushings and loads) do, let go level with its end O at the origin, over 0.5 s.
## @end deftypefn

function history = unheld_mechanisms (joints)
  rod = struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 2);
  scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0], "rotary_inertia", false))};
  scene.joints = joints;
  [scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.5, 20, 1e-8);
  evalc ("result = driver (scene, \"output\", \"\");");
  history = result.history;
endfunction

%!function center = center_of (history)
%!  body = history.bodies;
%!  center = [body.x + body.tip_x; body.y + body.tip_y]/2;
%!endfunction
%!test # nothing holds it: it falls
%! history = unheld_mechanisms ({});
%! assert (center_of (history), [0.5; 0] + [0; -9.81/2]*history.t.^2, 1e-7);
%!test # a force carries its weight and pushes it along
%! force = struct ("kind", "force", "bodies", 1, "stations", 0.5, "value", [3, 2*9.81]);
%! history = unheld_mechanisms ({force});
%! assert (center_of (history), [0.5; 0] + [3/2/2; 0]*history.t.^2, 1e-7);
%!test # a bushing at its middle: it oscillates about its static place, or creeps there at the limit of damping
%! bushing = struct ("kind", "bushing", "bodies", 1, "stations", 0.5, "point", [0.5 0], "stiffness", 200);
%! history = unheld_mechanisms ({bushing});
%! assert (center_of (history), [0.5; 0] + [0; 2*9.81/200]*(cos (10*history.t) - 1), 1e-6);
%! history = unheld_mechanisms ({setfield(bushing, "damping", 40)});
%! crept = (1 + 10*history.t).*exp (-10*history.t) - 1;
%! assert (center_of (history), [0.5; 0] + [0; 2*9.81/200]*crept, 1e-6);
%!test # two springs above its ends
%! spring = @(station) struct ("kind", "spring", "bodies", 1, "stations", station, "point", [station 1], "rest", 1, ...
%!                             "stiffness", 100);
%! history = unheld_mechanisms ({spring(0), spring(1)});
%! assert (center_of (history), [0.5; 0] + [0; 2*9.81/200]*(cos (10*history.t) - 1), 1e-6);
%!test # one constraint and no spring, one constraint and one spring, by methods of equal steps: the whole falls
%! bar = struct ("rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 2), "model", struct ("modes", [0 0]));
%! between = {struct("kind", "angle", "bodies", [1 2], "stations", [1 0])
%!            [struct("kind", "slider", "bodies", [1 2], "stations", [1 0.5], "stiffness", 0), ...
%!             struct("kind", "spring", "bodies", [1 2], "stations", [1 0], "stiffness", 10)]};
%! lastwarn ("");
%! for joints = between.'
%!   for name = {"variational", "generalized_alpha"}
%!     scene = struct ("duration", 0.1, "frames_per_second", 20, "solver", struct ("name", name{1}, "step", 1e-3));
%!     scene.bodies = {bar, setfield(bar, "initial", struct ("x", 1.5, "y", 0, "phi", 0.3))};
%!     scene.joints = num2cell (joints{1});
%!     history = driver (scene, "output", "").history;
%!     height = (history.bodies(1).y + history.bodies(1).tip_y + history.bodies(2).y + history.bodies(2).tip_y)/4;
%!     assert (height, height(1) - 9.81*history.t.^2/2, 1e-4); assert (last_warning (), "");
%!   endfor
%! endfor
