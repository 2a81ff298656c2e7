## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{points}] =} divided_scene (@var{scene})
## A checked @var{scene} of bodies whose straight rods are five pieces each (see @code{in_pieces}), and which of its
## points (see @code{mechanism_points}) are those of the scene itself; both are empty where all rods are curved.
## @end deftypefn

function [scene, points] = divided_scene (scene)
  points = [];
  count = 0;
  for body = scene.bodies
    own = 1:11;
    if (isempty (body.rod.curvature))
      own = [1, (6:5:51) + floor((0:9)/2)];
    endif
    points = [points, count + own];
    count += own(end);
  endfor
  if (numel (points) == count)
    scene = points = [];
  else
    scene = in_pieces (scene, 5);
  endif
endfunction

%!test # in pieces, of which these points are its own
%! scene = chain (2);
%! [scene.bodies{1}.model.modes, scene.bodies{2}.model.modes, scene.duration] = deal ([0 0], [0 0], 0.04);
%! scene.bodies{2}.rod.curvature = 0.1;
%! kind = mechanism_kind ();
%! scene = kind.check (scene);
%! [pieces, points] = divided_scene (scene);
%! assert (numel (pieces.bodies), 6); assert (numel (points), 22);
%! of = @(scene) run_model (kind, scene, kind.build (scene, kind.stated (scene)));
%! [whole, divided] = deal (of (scene), of (pieces));
%! assert ([divided.x(points,:), divided.y(points,:)], [whole.x, whole.y], 1e-6);
