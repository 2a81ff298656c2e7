## -*- texinfo -*-
## @deftypefn {} {@var{system} =} rod_system (@var{scene}, @var{model})
## The system of first order that moves the scene's rod: @code{hub_rod} where its rotation is prescribed, else
## @code{hinged_rod}.
## @end deftypefn

function system = rod_system (scene, model)
  kinds = {@hinged_rod, @hub_rod};
  system = kinds{2 - isempty(scene.rotation)} (scene, model);
endfunction

%!test
%! scene = check_scene (setfield (paper (), "model", "modes", [0 1]));
%! assert (numel (rod_system (scene, build_model (scene, rung_of_scene (scene))).initial_state), 6);
