## -*- texinfo -*-
## @deftypefn {} {@var{table} =} constraint_limits (@var{system}, @var{solver}, @var{seconds})
## What constraints do to the integrators of a mechanism's @var{system}: how far they are off after so many
## @var{seconds} by methods that integrate Phi'' = 0, with the tolerance of the checked scene's @var{solver}; the longest
## step by Baumgarte's terms with its rate; and the condition of Newton's matrix on index 3.  A struct array of method,
## what, predicted and measured, as from @code{stability}.
## @end deftypefn

function table = constraint_limits (system, solver, seconds)
  rows = cell (0, 4);
  for method = {"acceleration", "baumgarte", "projection"}
    what = sprintf ("constraints are off after %.3g s, tolerance %.2g m [m, rad]", seconds, solver.tolerance);
    rows(end+1,:) = {method{1}, what, NaN, drift(system, setfield (solver, "name", method{1}), seconds)};
  endfor
  what = sprintf ("limit of the step by its rate of %g 1/s [s]", solver.baumgarte);
  rows(end+1,:) = {"baumgarte", what, real_limit("ode45")/solver.baumgarte, NaN};
  rows = [rows; newton_condition(system, named_rows (system, system.initial_state), 10.^(-2:-2:-6))];
  table = cell2struct (rows, {"method", "what", "predicted", "measured"}, 2).';
endfunction

## NaN where the method fails
function off = drift (system, solver, seconds)
  off = NaN;
  try
    end_state = named_rows (system, integrate (system, [0, seconds], solver)(:,end));
    off = max (abs (system.at (seconds, end_state.q, end_state.v).constraints.residual));
  catch err
    rethrow_others (err, "toolchain:integration");
  end_try_catch
endfunction

%!function table = of_chain (modes, seconds)
%!  scene = chain (2);
%!  [scene.bodies{1}.model.modes, scene.bodies{2}.model.modes] = deal (modes);
%!  scene = check_mechanism (scene);
%!  kind = mechanism_kind ();
%!  system = kind.system (scene, kind.build (scene, kind.stated (scene)));
%!  solver = setfield (setfield (scene.solver, "tolerance", 1e-4), "baumgarte", 100);
%!  table = constraint_limits (system, solver, seconds);
%!endfunction
%!test # projection corrects what drifts, terms of Baumgarte most of it
%! drifted = [of_chain([0 0], 1)(1:3).measured];
%! assert (drifted(1) > 10*drifted(2) && drifted(2) > 10*drifted(3)); assert (drifted(3) < 1e-14);
%!test # scaled, the matrix is no worse for short steps
%! table = of_chain ([0 1], 1e-4);
%! assert (table(4).predicted, 3.3066/100, -1e-3);
%! assert (table(9).measured > 1e12*table(5).measured); assert (table(10).measured < table(6).measured);
