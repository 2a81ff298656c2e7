## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} trial_run (@var{scene}, @var{rung})
## Try a @var{rung} of the ladder on a checked scene of one rod: what @code{run_rod} returns, with rung, error and
## seconds (see @code{try_rung}).
## @end deftypefn

function trial = trial_run (scene, rung)
  trial = try_rung (rod_ladder (scene), rung);
endfunction

%!test # the rigid rod
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = trial_run (check_scene (setfield (paper (), "solver", "tolerance", 1e-6)), rigid);
%! assert (hypot (trial.x(end,:), trial.y(end,:)), ones (1, 91), 1e-12);
%! assert (trial.rung, rigid); assert (trial.error, "");
