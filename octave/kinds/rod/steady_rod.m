## -*- texinfo -*-
## @deftypefn {} {@var{turning} =} steady_rod (@var{kind}, @var{scene})
## One rod of a checked @var{scene} of a @var{kind} in steady rotation, in a hub or free at its hinge, without weight
## and loads, as @code{campbell} takes it: a struct of speed (rad/s, the largest that the scene's hub has, NaN without
## one) and about (speed, q), which is @code{about_rotation}.  Without stated modes it is far richer than what would be
## chosen.
## @end deftypefn

function turning = steady_rod (kind, scene)
  turning.speed = NaN;
  if (! isempty (scene.rotation))
    turning.speed = fastest_rotation (scene.rotation, scene.duration);
  endif
  [scene.gravity, scene.moment, scene.breaks, scene.force, scene.joints] = deal (0, @(t) 0*t, [], [], []);
  for name = {"phi_dot", "V1", "V2", "V1_dot", "V2_dot"}
    scene.initial.(name{1}) = 0;
  endfor
  rung = kind.stated (scene);
  if (isempty (rung))
    rung = kind.far_richer (scene, []);
  endif
  model = kind.build (scene, rung);
  softening_note ({model});
  turning.about = @(speed, q) about_rotation (scene, model, speed, q);
endfunction

%!test # a hub's largest speed, and none
%! assert (steady_rod (rod_kind (), check_scene (spin_up ())).speed, 6, 1e-6);
%! assert (steady_rod (rod_kind (), check_scene (swing ())).speed, NaN);
%!test # a rod that is free to turn does so, whatever weight and moment there would be
%! scene = check_scene (setfield (setfield (swing (), "model", "modes", [0 1]), "moment", 3));
%! about = steady_rod (rod_kind (), scene).about;
%! [linear, q] = about (5, []);
%! assert (q, [0; 0], 1e-9); assert ([linear.K(:,2); linear.C(:,2)], zeros (4, 1), 1e-6*linear.M(2,2));
