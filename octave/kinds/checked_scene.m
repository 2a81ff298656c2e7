## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{kind}, @var{output}, @var{name}] =} checked_scene (@var{which}, @var{options}, @
##   @var{change})
## A scene, checked and with a title, its kind (see @code{kind_of}), where its files go (see @code{take_options}), and
## its @var{name} (see @code{load_scene}): @var{which} and @var{options} (a cell array) are arguments as for
## @code{driver}; @var{change} (scene) is what is made of the scene before it is checked.
## With the option "exact" one rod is the geometrically exact rod (see @code{exact_scene}); without it
## output.exact comes back as "auto" where a tolerance in metres is stated and nothing of the model, and as false.
## @end deftypefn

function [scene, kind, output, name] = checked_scene (which, options, change = @(scene) scene)
  [scene, name] = load_scene (which);
  [scene, output] = take_options (scene, fullfile ("output", name), options);
  given = scene;
  scene = change (scene);
  kind = kind_of (scene);
  scene = kind.check (scene);
  if (isequal (output.exact, true))
    refuse_other_kind (kind, kind_of (given));
    [scene, kind] = exactly (scene, kind);
  elseif (isempty (output.exact))
    output.exact = exact_by_default (given);
  endif
  if (isempty (scene.title))
    scene.title = name;
  endif
endfunction

function refuse_other_kind (kind, given)
  if (! strcmp (kind.name, given.name))
    scene_error (["exact: this study takes a \"%s\" as a \"%s\", which has no exact rod: state the rod on an upright" ...
                  " plane, as the scene large_swing does"], given.name, kind.name);
  endif
endfunction

function [plane, kind] = exactly (scene, kind)
  [plane, lacks] = kind.exactly (scene);
  if (isempty (plane))
    scene_error ("exact: the geometrically exact rod lacks what the scene has: %s", lacks);
  endif
  kind = kind_of (plane);
  plane = kind.check (plane);
endfunction

## a tolerance in metres is a promise; a model that is stated is meant
function exact = exact_by_default (given)
  stated = @(part, name, default) ! isequal (field_or (field_or (given, part, struct ()), name, default), default);
  exact = false;
  if (stated ("solver", "tolerance", "pixel") && ! any (cellfun (@(name) stated ("model", name, "auto"), ...
                                                                 {"modes", "axial", "stiffening"})))
    exact = "auto";
  endif
endfunction

%!test
%! [scene, kind, output, name] = checked_scene (rmfield (swing (), "title"), {"modes", [0 1]});
%! assert (scene.model.modes, [0 1]); assert (kind.name, "rod"); assert (scene.title, name);
%! assert (output.folder, fullfile ("output", name));
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
%!error <exact: the geometrically exact rod lacks what the scene has: several bodies>
%! checked_scene ("double_pendulum", {"exact", true});
%!error <exact: the geometrically exact rod lacks what the scene has: a rod so thick that>
%! checked_scene (setfield (hook (), "rod", "half_height", 0.01), {"exact", true});
%!error <exact: this study takes a "rod" as a "mechanism", which has no exact rod>
%! checked_scene ("swing", {"exact", true}, @scene_at_rest);
