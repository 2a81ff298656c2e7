## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} scene_of_bodies (@var{given})
## A scene, not checked yet, in which one rod, if that is what it has, is one body (see @code{as_bodies}): the kind of
## a mechanism or of a rod on a surface.
## @end deftypefn

function scene = scene_of_bodies (given)
  scene = given;
  if (! isstruct (given) || isfield (given, "surface") || ! any (isfield (given, {"rod", "bodies"})))
    return;
  endif
  if (! isfield (given, "joints"))
    scene.joints = {};
  endif
  scene = as_bodies (spelled_start (scene));
endfunction

%!test # one rod with all that it states; what is none stays as it is
%! scene = scene_of_bodies (setfield (axial_shock (), "initial", "phi_dot", 3));
%! assert (kind_of (scene).name, "mechanism"); assert (scene.bodies{1}.initial.phi_dot, 3);
%! on_surface = bowl ();
%! assert (scene_of_bodies (on_surface), on_surface); assert (scene_of_bodies (3), 3);
