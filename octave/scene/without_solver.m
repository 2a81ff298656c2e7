## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} without_solver (@var{scene})
## A @var{scene}, not checked yet, for a study in which nothing is integrated: without the method and the step that it
## states, which its kind at rest need not have.
## @end deftypefn

function scene = without_solver (scene)
  solver = field_or (scene, "solver", struct ());
  scene.solver = rmfield (solver, intersect ({"name", "step"}, fieldnames (solver)));
endfunction

%!assert (without_solver (struct ("solver", struct ("name", "rk4", "tolerance", 1))).solver, struct ("tolerance", 1))
%!assert (without_solver (struct ("gravity", 0)).solver, struct ())
