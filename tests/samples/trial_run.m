## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} trial_run (@var{scene}, @var{rung})
## Try a @var{rung} of the ladder of models on a checked scene (see @code{try_rung}).
## @end deftypefn

function trial = trial_run (scene, rung)
  trial = try_rung (ladder_of (kind_of (scene), scene), rung);
endfunction

%!test
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "solver", "tolerance", 1e-6));
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! assert (trial_run (scene, rigid).rung, rigid);
