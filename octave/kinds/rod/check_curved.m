## -*- texinfo -*-
## @deftypefn {} {} check_curved (@var{scene})
## An error where a scene asks for what its curved rod does not take, or its curvature is none
## (see @code{check_curvature}).
## @end deftypefn

function check_curved (scene)
  refused = {"rotation", ! isempty(scene.rotation); "force", ! isempty(scene.force)
             "model.stiffening = \"foreshortening\"", strcmp(scene.model.stiffening, "foreshortening")
             "model.axial = \"quasistatic\"", strcmp(scene.model.axial, "quasistatic")};
  for row = refused.'
    if (row{2})
      scene_error (["%s and rod.curvature are both given: a curved rod by itself takes a moment at O, a tip mass," ...
                    " joints and its weight; a hub and forces it takes as a body (scene.bodies)"], row{1});
    endif
  endfor
  check_curvature (scene.rod, "");
endfunction

%!error <force and rod.curvature are both given>
%! check_scene (setfield (arc_pendulum (), "force", @(t) [0 1]));
