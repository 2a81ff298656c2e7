## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} scene_at_rest (@var{given})
## A scene as the studies of equilibrium take it, not checked yet: one rod is one body (see @code{scene_of_bodies}),
## and bodies have neither velocities nor modal amplitudes at the start.
## @end deftypefn

function scene = scene_at_rest (given)
  scene = scene_of_bodies (given);
  if (isfield (scene, "bodies") && iscell (scene.bodies))
    scene.bodies = cellfun (@placed, scene.bodies, "uniformoutput", false);
  endif
endfunction

function body = placed (body)
  if (isfield (body, "initial") && isstruct (body.initial))
    moving = intersect ({"phi_dot", "x_dot", "y_dot", "V1", "V2", "V1_dot", "V2_dot"}, fieldnames (body.initial));
    body.initial = rmfield (body.initial, moving);
  endif
endfunction

%!test # one rod, with what it states of its place, is a mechanism's scene; others stay as they are
%! scene = scene_at_rest (setfield (setfield (axial_shock (), "initial", "phi", 1), "initial", "phi_dot", 3));
%! assert (kind_of (scene).name, "mechanism");
%! assert (scene.bodies{1}.initial, struct ("phi", 1));
%! assert (kind_of (scene_at_rest (bowl ())).name, "surface");
