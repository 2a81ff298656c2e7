## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} moved_rods (@var{field}, @var{value}, @dots{})
## A soft rod on a plane, its end at O held, which starts to swing against it, for the tests of this file.
## @end deftypefn

function scene = moved_rods (varargin)
  scene = struct ("surface", struct ("name", "plane", "inclination", pi/2, "side", 0), "duration", 0.3, ...
                  "rod", struct ("length", 1, "EA", 500, "EI", 1, "rhoA", 1), "ends", {{"hinge", "free"}}, ...
                  "gravity", 0, "frames_per_second", 20, "model", struct ("modes", [6 6]), varargin{:});
  scene.solver.tolerance = 1e-7;
  scene.initial.velocity = @(xi, alpha) [0*xi; 2*xi.^2];
endfunction

%!function place = fall (t)   # from a height, with a push aside
%!  place = [3*t, -9.81*t^2/2; 3, -9.81*t; 0, -9.81];
%!endfunction
%!test # what falls with its end has no weight
%! alone = driver (moved_rods (), "output", "");
%! falls = driver (moved_rods ("gravity", 9.81, "place", @fall), "output", "");
%! assert (falls.history.q, alone.history.q, 1e-8);
%! assert (falls.history.tip - alone.history.tip, cell2mat (arrayfun (@(t) [fall(t)(1,1); 0; fall(t)(1,2)], ...
%!         alone.history.t, "uniformoutput", false)), 1e-8);
%! assert (falls.summary.largest_energy_error < 1e-6);
%! assert (range (alone.history.tip(3,:)) > 0.3);
%!test # nor does what turns in a hub that falls
%! hub = {"ends", {{"clamped", "free"}}, "rotation", @(t) [5*t^2, 10*t, 10]};
%! alone = driver (moved_rods (hub{:}), "output", "");
%! falls = driver (moved_rods (hub{:}, "gravity", 9.81, "place", @fall), "output", "");
%! assert (falls.history.q, alone.history.q, 1e-8);
%! assert (falls.history.torque, alone.history.torque, 1e-4);
%! assert (falls.summary.largest_energy_error < 1e-6);
%!test # to pull a stiff rod along a ruling of a cylinder takes its kinetic energy, m v^2/2, and a little that rings
%! cylinder = struct ("name", "cylinder", "radius", 1);
%! pulled = moved_rods ("surface", cylinder, "place", @(t) [2*t^2, 0; 4*t, 0; 4, 0]);
%! pulled.initial = struct ();
%! run = driver (setfield (pulled, "rod", "EA", 1e5), "output", "");
%! assert (run.history.W(end), (4*0.3)^2/2, 0.01);
%! assert (run.summary.largest_energy_error < 1e-6);
