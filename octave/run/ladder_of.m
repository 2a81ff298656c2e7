## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} ladder_of (@var{kind}, @var{scene})
## The ladder of models of a checked scene of a @var{kind} (see @code{kind_of}), as @code{choose} takes it: its trials
## are runs by the ladder's solver.
## @end deftypefn

function ladder = ladder_of (kind, scene)
  ladder = kind.ladder (scene);
  ladder.trial = @(rung) run_model (kind, scene, kind.build (scene, rung), ladder.solver);
endfunction

%!test # the rigid rod
%! scene = check_scene (setfield (paper (), "solver", "tolerance", 1e-6));
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = try_rung (ladder_of (rod_kind (), scene), rigid);
%! assert (hypot (trial.x(end,:), trial.y(end,:)), ones (1, 91), 1e-12);
%! assert (trial.rung, rigid); assert (trial.error, "");
