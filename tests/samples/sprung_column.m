## -*- texinfo -*-
## @deftypefn {} {@var{path} =} sprung_column (@var{lean})
## The @var{path} (see @code{path_point}) of a rigid column of 1 m and 1 kg at its top on a torsion spring of 1 N
## m/rad, that is unloaded at the angle @var{lean} (rad) from the upright, under 1 N down.
## @end deftypefn

function path = sprung_column (lean = 0)
  balance.n = 1;
  balance.multipliers = 0;
  balance.start = lean;
  balance.residual = @(factor, q, v, lambda) factor.*sin (q) - (q - lean);
  balance.tangent = @(factor, q, lambda) 1 - factor*cos (q);
  balance.mass = @(q) 1;
  balance.size = @(step) abs (step);
  balance.length = 1;
  path = struct ("balance", balance, "factors", [0 0.5 1.5], "range", 1.5, "size", 1, "mass", 1);
endfunction

%!test # it stands upright, and aslant where factor = q/sin (q)
%! balance = sprung_column ().balance;
%! assert (balance.residual ([0.5 1/sin(1)], [0 1], 0, []), [0 0], 1e-15);
