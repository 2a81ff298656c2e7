## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} scene_at_rest (@var{given})
## A scene as the studies of equilibrium take it, not checked yet: one rod is one body (see @code{scene_of_bodies}),
## bodies have neither velocities nor modal amplitudes at the start, longitudinal modes that follow quasi-statically are
## dynamic ones, which rest alike, and nothing has a method.
## @end deftypefn

function scene = scene_at_rest (given)
  if (isfield (given, "solver") && isstruct (given.solver))
    given.solver = rmfield (given.solver, intersect ({"name", "step"}, fieldnames (given.solver)));
  endif
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
  if (isfield (body, "model") && isfield (body.model, "axial") && strcmp (body.model.axial, "quasistatic"))
    body.model.axial = "dynamic";
  endif
endfunction

%!test # one rod, with what it states of its place, is a mechanism's scene; others stay as they are
%! scene = scene_at_rest (setfield (setfield (axial_shock (), "initial", "phi", 1), "initial", "phi_dot", 3));
%! assert (kind_of (scene).name, "mechanism");
%! assert (scene.bodies{1}.initial, struct ("phi", 1));
%! assert (kind_of (scene_at_rest (bowl ())).name, "surface");
%!test # what follows quasi-statically rests as what moves, and the only work of a moment may be stated
%! scene = setfield (setfield (swing (), "model", "axial", "quasistatic"), "model", "moment_work", "tangent");
%! assert (scene_at_rest (scene).bodies{1}.model, struct ("axial", "dynamic"));
%!test # a method is no matter
%! scene = scene_at_rest (setfield (swing (), "solver", struct ("name", "rk4", "step", 1e-4, "tolerance", 1e-3)));
%! assert (scene.solver, struct ("tolerance", 1e-3));
