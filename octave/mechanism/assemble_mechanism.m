## -*- texinfo -*-
## @deftypefn {} {[@var{start}, @var{warnings}] =} assemble_mechanism (@var{scene}, @var{mechanism}, @var{system})
## The first state, a struct of q, v, W, D: what the scene states, brought onto the constraints by projection in the mass
## metric; @var{warnings} (cellstr) say what that changed, and which bodies hang on nothing.
##
## A mechanism that cannot be assembled is an error that names the joints that stay apart, one whose constraints depend
## on each other one that names these.
## @end deftypefn

function [start, warnings] = assemble_mechanism (scene, mechanism, system)
  [given_q, given_v] = placed_bodies (scene, mechanism);
  [q, residual] = project_positions (system, 0, given_q);
  if (! (residual < 1e-9))
    refuse_open (scene, mechanism, system, q);
  endif
  at = system.at (0, q, given_v);
  [mass, jacobian] = system.matrices (at);
  refuse_dependent (system, 0, jacobian);
  v = project_velocities (system, 0, q, given_v);
  start = struct ("q", q, "v", v, "W", 0, "D", 0);
  warnings = [what_moved(q - given_q, v - given_v, mechanism, scene), loose_bodies(scene)];
endfunction

function refuse_open (scene, mechanism, system, q)
  residual = abs (system.at (0, q, 0*q).constraints.residual);
  joints = mechanism.constraints.joint(residual > max (residual)/100);
  names = unique ({scene.joints(joints).name});
  bodies = unique ([scene.joints(joints).bodies]);
  scene_error ("the mechanism cannot be assembled: %s stay apart by %.3g m (or rad); the loop through %s does not close", ...
               strjoin (names, ", "), max (residual), strjoin ({scene.bodies(bodies(bodies > 0)).name}, ", "));
endfunction

function warnings = what_moved (dq, dv, mechanism, scene)
  warnings = {};
  for k = 1:numel (scene.bodies)
    index = index_of (mechanism, k);
    l = scene.bodies(k).rod.length;
    metres = abs ([dq(index), dv(index)]).*[ones(numel (index) - 3, 1); l; 1; 1];
    moved = max (metres, [], 1);
    if (any (moved > 1e-9*[l, max(l, 1)]))
      warnings{end+1} = sprintf ("%s was moved by %.2g m and %.2g m/s to meet its joints", scene.bodies(k).name, moved);
    endif
  endfor
endfunction

function warnings = loose_bodies (scene)
  tied = false (1, numel (scene.bodies));
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
