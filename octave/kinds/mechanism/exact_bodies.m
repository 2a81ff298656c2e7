## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{lacks}] =} exact_bodies (@var{scene})
## A checked @var{scene} of bodies whose rods are geometrically exact (see @code{exact_equations}), with as many
## polynomials as each needs; those that are stated to be rigid, with modes = [0 0], are so.  Where that cannot be,
## @var{scene} is empty, and @var{lacks} (a text) says why.
## @end deftypefn

function [scene, lacks] = exact_bodies (scene)
  lacks = "";
  rigid = arrayfun (@(body) isequal (body.model.modes(:), [0; 0]), scene.bodies);
  deformed = arrayfun (@(body) any ([body.initial.V1(:); body.initial.V2(:); body.initial.V1_dot(:); ...
                                     body.initial.V2_dot(:)]), scene.bodies);
  thick = arrayfun (@(body) too_thick (body.rod, rod_section (body.rod, body.model)), scene.bodies);
  if (all (rigid))
    [scene, lacks] = lacking ("rods with modes = [0 0] alone");
  elseif (any (deformed & ! rigid))
    [scene, lacks] = lacking ("amplitudes of modes as its start");
  elseif (any (thick & ! rigid))
    [scene, lacks] = lacking ("a rod so thick that its curvature changes its section");
  elseif (! any (strcmp (scene.initial.from, {"", "equilibrium"})))
    [scene, lacks] = lacking ("another run's end as its start");
  else
    for k = find (! rigid(:).')
      scene.bodies(k).model.modes = "auto";
      scene.bodies(k).model.stiffening = "exact";
    endfor
  endif
endfunction

%!test # those that bend
%! scene = chain (2);
%! [scene.bodies{1}.model.modes, scene.bodies{2}.model.modes] = deal ([0 0], [1 2]);
%! bodies = exact_bodies (check_mechanism (scene)).bodies;
%! assert ({bodies(1).model.modes, bodies(2).model.modes}, {[0 0], "auto"});
%! assert (bodies(2).model.stiffening, "exact");
%!test # what has none
%! scene = chain (1);
%! scene.bodies{1}.model.modes = [0 0];
%! [none, lacks] = exact_bodies (check_mechanism (scene));
%! assert ({none, lacks}, {[], "rods with modes = [0 0] alone"});
%! scene.bodies{1}.model.modes = "auto";
%! there = setfield (check_mechanism (scene), "initial", "from", "output/there");
%! assert (nthargout (2, @exact_bodies, there), "another run's end as its start");
%! scene.bodies{1}.rod.curvature = 3;
%! scene.bodies{1}.rod.half_height = 0.1;
%! lacks = @(scene) nthargout (2, @exact_bodies, check_mechanism (scene));
%! assert (lacks (scene), "a rod so thick that its curvature changes its section");
%! scene.bodies{1}.initial.V2 = 1e-3;
%! assert (lacks (scene), "amplitudes of modes as its start");
