## -*- texinfo -*-
## @deftypefn {} {@var{mechanism} =} build_mechanism (@var{scene}, @var{rungs})
## The bodies and joints of a checked scene as arrays.  @var{rungs} has each body's rung of the ladder of models (see
## @code{rung_of_scene}).
##
## Fields: models (of the bodies), n (coordinates: (V; phi; x; y) of body after body), groups (equal bodies, whose
## equations are evaluated at once: what (they have in common, a cell array), model, bodies, index (coordinates, a
## column a body)), place (a row a body: the number of its group, and which of the group's bodies it is), markers and
## what else @code{list_markers} adds, constraints (see @code{list_constraints}), springs and loads (see
## @code{list_springs}), gravity.
## @end deftypefn

function mechanism = build_mechanism (scene, rungs)
  count = numel (scene.bodies);
  mechanism.models = cell (1, count);
  mechanism.groups = struct ([]);
  mechanism.gravity = scene.gravity;
  n = 0;
  for k = 1:count
    body = scene.bodies(k);
    what = {body.rod, rungs{k}, body.tip_mass, body.model};
    g = find (arrayfun (@(group) isequal (group.what, what), mechanism.groups), 1);
    if (isempty (g))
      g = numel (mechanism.groups) + 1;
      new = struct ("what", {what}, "model", free_rod_model (body, rungs{k}), "bodies", [], "index", []);
      mechanism.groups = [mechanism.groups, new];
    endif
    model = mechanism.groups(g).model;
    size_k = numel (model.arrays.coupling_vector) + 3;
    mechanism.models{k} = model;
    mechanism.groups(g).bodies(end+1) = k;
    mechanism.groups(g).index(:,end+1) = n + (1:size_k).';
    mechanism.place(k,:) = [g, numel(mechanism.groups(g).bodies)];
    n += size_k;
  endfor
  mechanism.n = n;
  mechanism = list_markers (mechanism, scene.joints);
  mechanism.constraints = list_constraints (mechanism, scene.joints);
  [mechanism.springs, mechanism.loads] = list_springs (mechanism, scene.joints);
endfunction

%!test # equal rods are one group
%! rod = struct ("length", 1, "EA", 1e6, "EI", 20, "rhoA", 1);
%! scene.bodies = {struct("rod", rod), struct("rod", rod), struct("rod", setfield (rod, "EI", 30))};
%! [scene.joints, scene.duration] = deal ({}, 1);
%! scene = check_mechanism (scene);
%! rung = struct ("sines", [1 2], "bending", 2, "longitudinal", 1, "axial", "dynamic", "stiffening", "none");
%! mechanism = build_mechanism (scene, {rung, rung, rung});
%! assert (numel (mechanism.groups), 2); assert (mechanism.n, 18);
%! assert (mechanism.groups(1).index(:,2), (7:12).');
