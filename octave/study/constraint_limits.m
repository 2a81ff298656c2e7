## -*- texinfo -*-
## @deftypefn {} {@var{table} =} constraint_limits (@var{system}, @var{rate})
## What constraints do to the integrators of a mechanism's @var{system}: the longest step by Baumgarte's terms with this
## @var{rate} (1/s), and the condition of Newton's matrix on index 3.  A struct array of method, what, predicted and
## measured, as from @code{stability}; how far constraints drift is in the chart of the scene.
## @end deftypefn

function table = constraint_limits (system, rate)
  what = sprintf ("limit of the step by its rate of %g 1/s [s]", rate);
  rows = {"baumgarte", what, real_limit("ode45")/rate, NaN};
  rows = [rows; newton_condition(system, named_rows (system, system.initial_state), 10.^(-2:-2:-6))];
  table = cell2struct (rows, {"method", "what", "predicted", "measured"}, 2).';
endfunction

%!test # a chain: scaled, the matrix is no worse for short steps
%! scene = check_mechanism (chain (2));
%! kind = mechanism_kind ();
%! system = kind.system (scene, kind.build (scene, kind.stated (scene)));
%! table = constraint_limits (system, 100);
%! assert (table(1).predicted, 3.3066/100, -1e-3);
%! assert (table(6).measured > 1e12*table(2).measured); assert (table(7).measured < table(3).measured);
