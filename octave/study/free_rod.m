## -*- texinfo -*-
## @deftypefn {} {[@var{system}, @var{scene}] =} free_rod (@var{modes}, @var{initial})
## The paper's rod of so many sines, @var{modes} = [N1 N2], as a system (see @code{hinged_rod}) without weight and
## moment: what studies of stability look at.  @var{initial} is a struct of fields of scene.initial.
## @end deftypefn

function [system, scene] = free_rod (modes, initial)
  scene = load_scene ("paper");
  scene.gravity = 0;
  scene.moment = 0;
  scene.moment_breaks = [];
  scene.initial = initial;
  scene.model.modes = modes;
  scene = check_scene (scene);
  system = rod_system (scene, build_model (scene, rung_of_scene (scene)));
endfunction

%!test # no load, no breaks
%! system = free_rod ([0 1], struct ("phi", 1));
%! assert (system.initial_state(2), 1); assert (isempty (system.breaks));
