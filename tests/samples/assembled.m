## -*- texinfo -*-
## @deftypefn {} {[@var{start}, @var{warnings}, @var{system}] =} assembled (@var{scene}, @var{level})
## A @var{scene} of bodies, checked and assembled (see @code{assemble_mechanism}), with so many bending modes (the
## @var{level}) of each body that does not state them.
## @end deftypefn

function [start, warnings, system] = assembled (scene, level)
  scene = check_mechanism (scene);
  levels = level*ones (1, numel (scene.bodies));
  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, levels)));
  [start, warnings] = assemble_mechanism (scene, system.mechanism, system);
endfunction

%!test # it hangs as it is laid
%! [start, warnings] = assembled (double_pendulum (), 0);
%! assert (start.q(2:3), [0; 0], 1e-12); assert (isempty (warnings));
