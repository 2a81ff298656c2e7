## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{kind}, @var{output}, @var{name}] =} checked_scene (@var{which}, @var{options}, @
##   @var{change})
## A scene, checked and with a title, its kind (see @code{kind_of}), where its files go (see @code{take_options}), and
## its @var{name} (see @code{load_scene}): @var{which} and @var{options} (a cell array) are arguments as for
## @code{driver}; @var{change} (scene) is what is made of the scene before it is checked.
## @end deftypefn

function [scene, kind, output, name] = checked_scene (which, options, change = @(scene) scene)
  [scene, name] = load_scene (which);
  [scene, output] = take_options (scene, fullfile ("output", name), options);
  scene = change (scene);
  kind = kind_of (scene);
  scene = kind.check (scene);
  if (isempty (scene.title))
    scene.title = name;
  endif
endfunction

%!test
%! [scene, kind, output, name] = checked_scene (rmfield (swing (), "title"), {"modes", [0 1]});
%! assert (scene.model.modes, [0 1]); assert (kind.name, "rod"); assert (scene.title, name);
%! assert (output.folder, fullfile ("output", name));
%! assert (checked_scene ("swing", {}, @(scene) setfield (scene, "duration", 2)).duration, 2);
