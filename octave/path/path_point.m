## -*- texinfo -*-
## @deftypefn {} {[@var{point}, @var{sweeps}] =} path_point (@var{path}, @var{x}, @var{lambda}, @var{normal})
## The equilibrium of a @var{path} (see @code{load_path}) on the plane through @var{x} = [q; factor] (n+1-by-1) across
## @var{normal} (n+1-by-1), by Newton's iteration from there and the multipliers @var{lambda}, in so many @var{sweeps};
## empty where it does not converge, or where the mass is not positive, as that of rods with foreshortening that bend
## too far is not.
##
## @var{point} is a struct of x, lambda, linear (see @code{held_tangent}), load (n-by-1, the forces' derivative by the
## factor), squares (1/s^2, ascending: of the frequency of each undamped vibration, minus that of the rate with which
## it grows), flutters (1-by-p, whether it then oscillates), modes (n-by-p), unstable (how many grow) and metric
## (n+1-by-n+1, in which dx has the length @code{sqrt (dx.'*metric*dx)}: m, root of a mean square).
## @end deftypefn

function [point, sweeps] = path_point (path, x, lambda, normal)
  balance = path.balance;
  n = balance.n;
  plane = normal.'*x;
  moved = [];
  for sweeps = 1:10
    linear = held_tangent (balance, x(end), x(1:n), lambda);
    [r, load] = forces_of (balance, x, lambda);
    onto = -inverse_of (linear.jacobian)*r(n+1:end,1);
    force = linear.basis.'*(r(1:n) - linear.stiffness*onto);
    dx = [onto; 0] + bordered (linear, load, normal, force, plane - normal.'*(x + [onto; 0]));
    x += dx;
    lambda += inverse_of (linear.jacobian).'*(r(1:n) + load*dx(end) - linear.stiffness*dx(1:n));
    moved(sweeps) = max (balance.size (dx(1:n))/path.size, abs (dx(end))/path.range) + 0*sum (dx);  # NaN stays NaN
    if (has_come (moved))
      if (sweeps == 1)  # what is straight stays where it is, but bears more
        linear = held_tangent (balance, x(end), x(1:n), lambda);
      endif
      [~, indefinite] = chol ((linear.M + linear.M.')/2);
      if (indefinite)
        break;
      endif
      point = judged (path, struct ("x", x, "lambda", lambda, "linear", linear, "load", load, "tangent", [], ...
                                    "bend", 0, "event", "", "turns", []));
      return;
    elseif (! (moved(end) < 10) || (sweeps > 4 && moved(end) > moved(end-1)))  # it goes astray
      break;
    endif
  endfor
  point = [];
endfunction

## and their derivative by the factor, in which they are linear
function [r, load] = forces_of (balance, x, lambda)
  q = repmat (x(1:end-1), 1, 2);
  both = balance.residual ([0 1], q, 0*q, lambda);
  r = both(:,1);
  load = (both(:,2) - r)(1:balance.n);
  r(1:balance.n) += x(end)*load;
endfunction

## as they fall, sweeps end where the next one moves nothing any more, or rounding alone
function yes = has_come (moved)
  yes = moved(end) < 1e-9;
  if (numel (moved) == 2)
    yes |= moved(2) < 1e-7 && moved(2)^2/moved(1) < 1e-10;
  endif
  if (numel (moved) > 2)
    ratios = moved(end-1:end)./moved(end-2:end-1);
    yes |= all (ratios < 1) && moved(end)*ratios(2) < 1e-10;
  endif
  if (numel (moved) > 3)
    yes |= moved(end) < 1e-6 && ratios(2) > 0.5;
  endif
endfunction

## what vibrates about it, as if nothing damped it
function point = judged (path, point)
  linear = point.linear;
  linear.C = 0*linear.M;
  vibration = vibrations (linear);
  grows = vibration.rate.^2 > 1e-14*max ([vibration.omega, vibration.rate].^2);
  squares = vibration.omega.^2;
  squares(grows) = -vibration.rate(grows).^2;
  [point.squares, order] = sort (squares);
  point.unstable = sum (grows);
  point.flutters = (grows & vibration.omega > 0)(order);
  point.modes = linear.basis*vibration.shape(:,order);
  point.metric = blkdiag (linear.mass/path.mass, (path.size/path.range)^2);
endfunction

%!test # a rigid pendulum of 1 kg and 1 m that a force along x draws aside: F = m g/2 tan, at a factor and at an angle
%! path = pulled_pendulum ();
%! point = path_point (path, [-pi/2; 0; 0; 2], zeros (2, 1), [0; 0; 0; 1]);
%! assert (tan (point.x(1) + pi/2), 2/(9.81/2), 1e-10); assert (point.unstable, 0);
%! assert (point.squares, 3/2*9.81*sqrt (1 + (2/(9.81/2))^2), 1e-6);
%! assert (point.load, [cos(point.x(1) + pi/2); 1; 0], 1e-9);
%! point = path_point (path, [-pi/4; 0; 0; 2], zeros (2, 1), [1; 0; 0; 0]);
%! assert (point.x([1 4]), [-pi/4; 9.81/2], 1e-10);
%!test # nothing is balanced above a moment of 1 N m more than the weight has
%! assert (path_point (pulled_pendulum ("moment"), [0; 0; 0; 9.81/2 + 1], zeros (2, 1), [0; 0; 0; 1]), []);
%!test # nor where motions would have no inertia
%! path = pulled_pendulum ();
%! path.balance.mass = @(q) -eye (3);
%! assert (path_point (path, [-pi/2; 0; 0; 2], zeros (2, 1), [0; 0; 0; 1]), []);
