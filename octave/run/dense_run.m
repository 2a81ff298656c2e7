## -*- texinfo -*-
## @deftypefn {} {@var{dense} =} dense_run (@var{kind}, @var{scene}, @var{run}, @var{rate})
## The @var{run} (see @code{kind_of}) of a checked scene once more, by the same model and solver, observed at
## @var{rate} times a second.
## @end deftypefn

function dense = dense_run (kind, scene, run, rate)
  scene.frames_per_second = rate;
  dense = run_model (kind, scene, run.model, run.solver, run);
endfunction

%!test # the same motion, ten times as often
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 2]), "duration", 0.5));
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%! dense = dense_run (rod_kind (), scene, run, 500);
%! assert (numel (dense.history.t), 251);
%! assert (dense.history.tip_x(1:10:end), run.history.tip_x, 1e-9);
