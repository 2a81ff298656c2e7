## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{rung}] =} richest_run (@var{kind}, @var{scene}, @var{model})
## The run of a checked scene of a @var{kind} by the @var{rung} far above a @var{model}'s (see far_richer in
## @code{kind_of}), by the solver "auto" with a twentieth of the tolerance.
## @end deftypefn

function [run, rung] = richest_run (kind, scene, model)
  rung = kind.far_richer (scene, model);
  scene.solver.name = "auto";
  scene.solver.tolerance /= 20;
  run = run_model (kind, scene, kind.build (scene, rung));
endfunction

%!test
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "modes", [0 0]));
%! [run, rung] = richest_run (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%! assert (run.model.rung, rung); assert (rung.bending, 30);
