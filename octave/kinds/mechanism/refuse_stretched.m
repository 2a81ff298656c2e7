## -*- texinfo -*-
## @deftypefn {} {} refuse_stretched (@var{system}, @var{given}, @var{q})
## An error where the rods of a mechanism's @var{system} (see @code{mechanism_system}), which the scene places at the
## coordinates @var{given} (n-by-1), are strained by more than a tenth more at @var{q}, where they meet their joints:
## as those of a loop that does not close, and which are not rigid, are.
## @end deftypefn

function refuse_stretched (system, given, q)
  [~, before] = system.steepest (given);
  [~, strain] = system.steepest (q);
  if (strain > before + 0.1)
    scene_error (["the mechanism cannot be assembled: it has a loop that closes with a strain of %.2g only; its rods" ...
                  " are too short for it, or too long"], strain);
  endif
endfunction

%!error <a loop that closes with a strain of 0.79 only; its rods are too short>  # pi/2 0.5 of a quarter wave
%! rod.rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! scene.bodies = {setfield(rod, "model", "modes", [1 0])};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", 1, "stations", 1, "point", [1.5 0])};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! assembled_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%!test # what the scene itself strains is not refused
%! system.steepest = @(q) deal (0, q);
%! refuse_stretched (system, 0.3, 0.35); refuse_stretched (system, 0, 0.09);
