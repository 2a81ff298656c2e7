## -*- texinfo -*-
## @deftypefn {} {[@var{start}, @var{warnings}] =} assemble_mechanism (@var{scene}, @var{mechanism}, @var{system})
## The first state, a struct of q, v, lambda (0: not known), W, D: what the scene states, brought onto the constraints
## by projection, of positions in the metric of mass and stiffness (rods are moved, not bent), of velocities in the
## mass metric; @var{warnings} (cellstr) say what that changed, and which bodies hang on nothing.
##
## A mechanism that cannot be assembled is an error that names the joints that stay apart, one whose constraints depend
## on each other one that names these; a spring without a direction is one, too.
## @end deftypefn

function [start, warnings] = assemble_mechanism (scene, mechanism, system)
  [given.q, given.v] = placed_bodies (scene, mechanism);
  [q, residual] = project_positions (system, 0, given.q, 1);
  if (! (residual < 1e-9))
    refuse_open (scene, mechanism, system, q);
  endif
  refuse_stretched (system, given.q, q);
  at = system.at (0, q, given.v);
  [mass, jacobian] = system.matrices (at);
  refuse_dependent (system, 0, jacobian);
  refuse_coincident (scene.joints, mechanism, at.markers);
  v = project_velocities (system, 0, q, given.v);
  start = struct ("q", q, "v", v, "lambda", zeros (system.constraint_count, 1), "W", 0, "D", 0);
  warnings = [what_moved(given, start, mechanism, scene), loose_bodies(scene), locked(scene, system), ...
              jerked_rods(scene, mechanism.constraints, at.constraints.velocity), ...
              wound_springs(scene.joints, mechanism.springs.joint, at.springs.residual)];
endfunction

function refuse_open (scene, mechanism, system, q)
  residual = abs (system.at (0, q, 0*q).constraints.residual);
  joints = mechanism.constraints.joint(residual > max (residual)/100);
  names = unique ({scene.joints(joints).name});
  bodies = unique ([scene.joints(joints).bodies]);
  loop = {scene.bodies(bodies(bodies > 0)).name};
  scene_error (["the mechanism cannot be assembled: %s stay apart by %.3g m (or rad); the loop through %s" ...
                " does not close"], strjoin (names, ", "), max (residual), strjoin (loop, ", "));
endfunction

## ends and middles of rods
function warnings = what_moved (given, start, mechanism, scene)
  warnings = {};
  for k = 1:numel (scene.bodies)
    index = index_of (mechanism, k);
    model = mechanism.models{k};
    motion = motion_of_rods ([given.q(index), start.q(index)], [given.v(index), start.v(index)]);
    moved = [0 0];
    for station = model.length*[0 0.5 1]
      [x, y, x_dot, y_dot] = model.equations.point (motion, model.equations.marker (model, station));
      moved = max (moved, [hypot(diff (x), diff (y)), hypot(diff (x_dot), diff (y_dot))]);
    endfor
    if (any (moved > 1e-9*[model.length, max(model.length, 1)]))
      warnings{end+1} = sprintf ("%s was moved by %.2g m and %.2g m/s to meet its joints", ...
                                 scene.bodies(k).name, moved);
    endif
  endfor
endfunction

function warnings = locked (scene, system)
  warnings = {};
  kinds = system.mechanism.constraints.kinds;
  driven = arrayfun (@(kind) ! isempty (kind.moving), kinds);
  chosen = arrayfun (@(body) ischar (body.model.modes), scene.bodies);  # such rods bend where that is seen
  if (system.n == system.constraint_count && ! any (driven) && ! any (chosen))
    warnings = {sprintf("the mechanism is locked: %d constraints on %d coordinates, and no joint is driven", ...
                        system.constraint_count, system.n)};
  endif
endfunction

## without gravity none falls
function warnings = loose_bodies (scene)
  tied = repmat (scene.gravity == 0, 1, numel (scene.bodies));
  do
    before = sum (tied);
    for joint = scene.joints(:).'
      on = joint.bodies(joint.bodies > 0);
      if (any (joint.bodies == 0) || any (tied(on)))
        tied(on) = true;
      endif
    endfor
  until (sum (tied) == before)
  warnings = cellfun (@(name) sprintf ("%s hangs on nothing: no joints lead from it to the ground", name), ...
                      {scene.bodies(! tied).name}, "uniformoutput", false);
endfunction

%!function scene = bars (coupler)
%!  rod = @(l) struct ("rod", struct ("length", l, "EA", 1, "EI", 1, "rhoA", 1), "model", struct ("modes", [0 0]));
%!  scene.bodies = {rod(0.2), setfield(rod (coupler), "initial", struct ("phi", 0.5)), ...
%!                  setfield(rod (0.5), "initial", struct ("phi", 1.5))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                  struct("kind", "revolute", "bodies", [1 2], "stations", [0.2 0]), ...
%!                  struct("kind", "revolute", "bodies", [2 3], "stations", [coupler 0.5], "name", "pin"), ...
%!                  struct("kind", "revolute", "bodies", 3, "stations", 0, "point", [0.6 0])};
%!  scene.duration = 1;
%!endfunction
%!test # a loop closes, and what moved is said
%! [start, warnings, system] = assembled (bars (0.7), 0);
%! assert (abs (system.at (0, start.q, start.v).constraints.residual) < 1e-11);
%! assert (! isempty (strfind (warnings{1}, "was moved by")));
%!error <cannot be assembled: .*; the loop through .*body 2.* does not close> assembled (bars (2), 0)
%!error <[0-9] of 9 constraints depend on the others, those of .*: take a joint of another kind there, or none>
%! scene = bars (0.7); scene.joints{5} = struct ("kind", "slider", "bodies", 3, "stations", 0, "point", [0.6 0]);
%! assembled (scene, 0);
%!test # springs, bushings and loads alone hold it, or nothing does: it has no constraints
%! scene = setfield (bars (0.7), "joints", {});
%! [start, warnings] = assembled (scene, 0);
%! assert (start.q, [0; 0; 0; 0.5; 0; 0; 1.5; 0; 0]);
%! assert (warnings, strcat ({"body 1", "body 2", "body 3"}, " hangs on nothing: no joints lead from it to the ground"));
%! [~, warnings] = assembled (setfield (scene, "gravity", 0), 0);
%! assert (warnings, {});
%! scene.bodies = scene.bodies(1);
%! scene.joints = {struct("kind", "bushing", "bodies", 1, "stations", 0, "stiffness", 3)};
%! [start, warnings] = assembled (scene, 0);
%! assert (isempty (warnings));
%!test # what hangs on nothing, and what cannot move
%! scene = bars (0.7); scene.joints(4) = [];
%! scene.joints(1) = [];
%! [~, warnings] = assembled (scene, 0);
%! assert (any (! cellfun (@isempty, strfind (warnings, "hangs on nothing"))));
%! scene = bars (0.7); scene.joints{5} = struct ("kind", "angle", "bodies", 1, "stations", 0);
%! [~, warnings] = assembled (scene, 0);
%! assert (any (! cellfun (@isempty, strfind (warnings, "is locked"))));
%!error <joint 6: the points of the spring coincide at the start, .*: take a bushing, which holds two points together>
%! scene = bars (0.7); scene.joints{5} = struct ("kind", "bushing", "bodies", [1 2], "stations", [0.2 0]);
%! scene.joints{6} = struct ("kind", "spring", "bodies", [1 2], "stations", [0.2 0], "stiffness", 1, "rest", 1);
%! assembled (scene, 0);
%!test # a rod that nothing holds
%! scene = setfield (bars (0.7), "joints", {});
%! scene.bodies = scene.bodies(1);
%! [start, warnings] = assembled (scene, 0);
%! assert (start.q, zeros (3, 1)); assert (warnings, {"body 1 hangs on nothing: no joints lead from it to the ground"});
%!test # a driven joint has the place and the rate of the start
%! scene = setfield (bars (0.7), "bodies", bars (0.7).bodies(1));
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [0.3 + 2*t, 2, 0])};
%! [start, warnings] = assembled (scene, 0);
%! assert (start.q, [0.3; 0; 0], 1e-12); assert (start.v(1), 2, 1e-12);
%! assert (warnings, {"body 1 was moved by 0.06 m and 0.4 m/s to meet its joints"});
%!test # a whole turn moves nothing, but winds a spring
%! scene = setfield (bars (0.7), "bodies", bars (0.7).bodies(1));
%! joint = @(kind, varargin) struct ("kind", kind, "bodies", 1, "stations", 0, varargin{:});
%! scene.joints = {joint("revolute"), joint("torsion_spring", "stiffness", 1, "rest", 2*pi)};
%! assert (strncmp (nthargout (2, @assembled, scene, 0), "joint 2 begins -6.28 rad from its rest", 38));
%! scene.joints{2} = joint ("angle", "value", @(t) [2*pi + t^2, 2*t, 2]);
%! assert (isempty (nthargout (2, @assembled, scene, 0)));
