## -*- texinfo -*-
## @deftypefn {} {@var{factor} =} buckling_factor (@var{kind}, @var{scene}, @var{t})
## The smallest positive @var{factor} of the loads of a checked scene at rest of a @var{kind} (see
## @code{scene_at_rest}) at the time @var{t} (s) at which its tangent stiffness, with its constraints, is singular; Inf
## where there is none. The stiffness is taken to be linear in the loads ("linearised buckling", as Cook et al. 2002,
## section 18.2, have it), by its change from no load to a thousandth of them, which is exact where the rod moves
## little before it buckles.
## @end deftypefn

function factor = buckling_factor (kind, scene, t)
  factor = singular_at (at_rest (kind, growing_loads (scene, t), 0, @singular_at, 1e-4));
endfunction

function factor = singular_at (found)
  share = 1e-3;
  [q, lambda] = equilibrium (found.balance, share, found.q);
  unloaded = bordered_tangent (found.balance, 0, found.q, found.lambda);
  change = (bordered_tangent (found.balance, share, q, lambda) - unloaded)/share;
  factors = eig (unloaded, -change);
  real_ones = abs (imag (factors)) <= 1e-6*abs (factors) & isfinite (factors);
  factor = min ([Inf; real(factors(real_ones & real (factors) > 0))]);
endfunction

## singular where the stiffness of what the constraints leave free is
function A = bordered_tangent (balance, t, q, lambda)
  tangent = balance.tangent (t, q, lambda);
  n = balance.n;
  K = (tangent(1:n,:) + tangent(1:n,:).')/2;
  J = tangent(n+1:end,:);
  A = [K, J.'; J, zeros(rows (J))];
endfunction

%!function scene = column (joints)
%!  scene.bodies = {struct("rod", struct ("length", 2, "EA", 1e7, "EI", 10, "rhoA", 1))};
%!  scene.joints = [joints, {struct("kind", "force", "bodies", 1, "stations", 2, "value", [-5 0])}];
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!  scene = check_mechanism (scene);
%!endfunction
%!test # Euler's columns: hinged, clamped and free, clamped and hinged (tan x = x), clamped at both ends
%! at = @(kind, s, varargin) struct ("kind", kind, "bodies", 1, "stations", s, varargin{:});
%! guide = at ("slider", 2, "point", [0 0], "direction", 0);
%! upright = at ("angle", 2, "value", 0);
%! ends = {{at("revolute", 0), guide}, {at("weld", 0)}, {at("weld", 0), guide}, {at("weld", 0), guide, upright}};
%! squares = [pi, pi/2, fzero(@(x) tan (x) - x, [4 4.6]), 2*pi].^2;
%! for k = 1:4
%!   assert (buckling_factor (mechanism_kind (), column (ends{k}), 0), 10*squares(k)/4/5, -1e-5);
%! endfor
%!test # pulled, nothing buckles; without loads nothing can
%! scene = column ({struct("kind", "weld", "bodies", 1, "stations", 0)});
%! scene.joints(2).value = @(t) [5 0];
%! assert (buckling_factor (mechanism_kind (), scene, 0), Inf);
%!test
%! scene = column ({struct("kind", "weld", "bodies", 1, "stations", 0)});
%! scene.joints(2).value = @(t) [0 0];
%! fail ("buckling_factor (mechanism_kind (), scene, 0)", "no force and no moment");
