## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{kind}, @var{output}, @var{name}] =} checked_scene (@var{which}, @var{options}, @
##   @var{change})
## A scene, checked and with a title, its kind (see @code{kind_of}), where its files go (see @code{take_options}), and
## its @var{name} (see @code{load_scene}): @var{which} and @var{options} (a cell array) are arguments as for
## @code{driver}; @var{change} (scene) is what is made of the scene before it is checked.
## output.given is the scene as it is stated.  With the option "exact" rods are geometrically exact (see exactly in
## @code{kind_of}); without it output.exact comes back as "auto" where a tolerance in metres is stated and nothing of
## the model, and as false.
## @end deftypefn

function [scene, kind, output, name] = checked_scene (which, options, change = @(scene) scene)
  [scene, name] = load_scene (which);
  [scene, output] = take_options (scene, fullfile ("output", name), options);
  output.given = scene;
  scene = change (scene);
  kind = kind_of (scene);
  if (isequal (output.exact, true))
    [scene, kind] = exactly (scene, kind, name);
  else
    scene = titled (kind.check (scene), name);
  endif
  if (isempty (output.exact))
    output.exact = exact_by_default (output.given, kind.models (scene));
  endif
endfunction

function scene = titled (scene, name)
  if (isempty (scene.title))
    scene.title = name;
  endif
endfunction

## where the exact rod is of another kind, it has methods of its own, of which exactly judges
function [plane, kind] = exactly (scene, kind, name)
  solver = field_or (scene, "solver", []);
  asked = field_or (solver, "name", []);
  of_another = isstruct (solver) && ischar (asked) && ! strcmp (kind.of_exact (scene).name, kind.name);
  if (of_another)
    scene.solver.name = "auto";
  endif
  scene = titled (kind.check (scene), name);
  if (of_another)
    scene.solver.name = asked;
  endif
  [plane, lacks] = kind.exactly (scene);
  if (isempty (plane))
    scene_error ("exact: the geometrically exact rod lacks what the scene has: %s", lacks);
  endif
  kind = kind.of_exact (plane);
endfunction

## a tolerance in metres is a promise; a model that is stated is meant, but that some bodies are rigid
function exact = exact_by_default (given, models)
  exact = false;
  stated = @(model, name) ! strcmp (field_or (model, name, "auto"), "auto");
  fixed = arrayfun (@(model) any (cellfun (@(name) stated (model, name), {"modes", "axial", "stiffening"})), models);
  rigid = arrayfun (@(model) isequal (field_or (model, "modes", [])(:), [0; 0]), models);
  in_metres = ! strcmp (field_or (field_or (given, "solver", struct ()), "tolerance", "pixel"), "pixel");
  if (in_metres && all (! fixed | rigid) && ! all (fixed))
    exact = "auto";
  endif
endfunction

%!test
%! [scene, kind, output, name] = checked_scene (rmfield (swing (), "title"), {"modes", [0 1]});
%! assert (scene.model.modes, [0 1]); assert (kind.name, "rod"); assert (scene.title, name);
%! assert (output.folder, fullfile ("output", name)); assert (output.given.model, struct ("modes", [0 1]));
%! assert (checked_scene ("swing", {}, @(scene) setfield (scene, "duration", 2)).duration, 2);
%!test # exactly: on the plane, or not at all
%! [scene, kind, output] = checked_scene ("swing", {"exact", true});
%! assert (scene.surface.name, "plane"); assert (kind.name, "exact"); assert (output.folder, "output/swing");
%!test # by itself only where a tolerance is stated, and no model
%! exact = @(varargin) nthargout (3, @checked_scene, "swing", varargin).exact;
%! assert ({exact(), exact("tolerance", 1e-3), exact("tolerance", 1e-3, "exact", false), exact("exact", "auto")}, ...
%!         {false, "auto", false, "auto"});
%! assert (exact ("tolerance", 1e-3, "modes", [0 2]), false);
%! of = @(name) nthargout (3, @checked_scene, setfield (swing (), "model", name, "none"), {"tolerance", 1}).exact;
%! assert ({of("axial"), of("stiffening")}, {false, false});
%!test # bodies, where none of them states its model but as rigid
%! exact = @(varargin) nthargout (3, @checked_scene, chain (2), [{"tolerance", 1e-3}, varargin]).exact;
%! assert ({exact(), exact("modes", "auto")}, {false, "auto"});
%! scene = chain (2);
%! [scene.bodies{1}.model.modes, scene.bodies{2}.model.modes] = deal ([0 0], "auto");
%! assert (nthargout (3, @checked_scene, scene, {"tolerance", 1e-3}).exact, "auto");
%! [scene, kind] = checked_scene (chain (2), {"modes", "auto", "exact", true});
%! assert ({scene.bodies(2).model.stiffening, kind.name}, {"exact", "mechanism"});
%!error <exact: the geometrically exact rod lacks what the scene has: a rod so thick that>
%! checked_scene (setfield (hook (), "rod", "half_height", 0.01), {"exact", true});
%!test # geometrically exact rods have methods and the title of their scene
%! arc = rmfield (arc_pendulum (), "title");
%! [scene, ~, ~, name] = checked_scene (arc, {"exact", true, "solver", "radau"});
%! assert ({scene.solver.name, scene.title, scene.exact.title}, {"radau", name, name});
%!error <the geometrically exact rod lacks what the scene has: the solver waveform>
%! checked_scene (arc_pendulum (), {"exact", true, "solver", "waveform"});
%!error <solver is a double: it takes a struct> checked_scene (setfield (swing (), "solver", 3), {"exact", true});
