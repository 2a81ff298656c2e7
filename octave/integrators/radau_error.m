## -*- texinfo -*-
## @deftypefn {} {@var{ratio} =} radau_error (@var{system}, @var{rule}, @var{factors}, @var{h}, @var{x}, @var{start}, @
##   @var{tolerance})
## The embedded error of panels of @var{h} (s; see @code{radau_window}) as parts of the @var{tolerance}, in points of
## the @var{system} (1-by-panels): what the polynomials through start and stages lack at the start of the rates there,
## with the weights of the @var{rule} (Hairer and Wanner, IV.8), under the real ones of the @var{factors}, so that
## stiff modes count as what they will be.
##
## @var{x} has q and v of the stages (rows-by-panels*stages), @var{start} q, v and a where the panels begin
## (rows-by-panels).
## @end deftypefn

function ratio = radau_error (system, rule, factors, h, x, start, tolerance)
  beyond = @(x, start, rate) factors.M*((reshape (x, [], numel (rule.c)) - start(:))*rule.e.'/h + rate(:));
  [q, v, lambda, mu, sigma] = factors.parts{:};
  no_forces = zeros (numel ([lambda, mu, sigma]), 1);
  off = radau_solve (factors, 1, [beyond(x.q, start.q, start.v); beyond(x.v, start.v, start.a); no_forces]);
  points = @(off) system.q_points*reshape (off, system.n, []);
  ratio = max (abs ([points(off(q)); h*points(off(v))]), [], 1)/tolerance;
endfunction

%!function [ratio, rule, g] = of_powers (m, k, h, part = 1)
%!  ## of a unit mass on k with q = part*t^m/m, v = t^(m-1), in panels from 0 and from 1 on
%!  rule = radau_rule (3);
%!  none = sparse (0, 2);
%!  springs = struct ("stiffness", zeros (0, 2), "damping", zeros (0, 2));
%!  factors = radau_factors (rule, h, speye (2), k*speye (2), sparse (2, 2), none, none, springs, 2);
%!  g = factors.stages{1}.g;
%!  q = @(t) reshape (part*t.^m/m, 1, []);
%!  v = @(t) reshape (t.^(m-1), 1, []);
%!  t = [0; 1] + h*rule.c;
%!  start = struct ("q", q ([0 1]), "v", v ([0 1]), "a", (m - 1)*[0 1].^(m-2));
%!  system = struct ("n", 1, "q_points", [2; 1]);
%!  ratio = radau_error (system, rule, factors, h, struct ("q", q (t), "v", v (t)), start, 1e-3);
%!endfunction
%!test # none of polynomials of the third degree; of the next ones, by hand, twice as much at a point that goes twice
%! assert (of_powers (3, 0, 0.1), [0 0], 1e-10);
%! [ratio, rule, g] = of_powers (5, 0, 0.1);
%! v = 0.1^3*(rule.e*rule.c.'.^4)/g;
%! q = v/g + 0.1^4*(rule.e*rule.c.'.^5)/5/g;
%! assert (ratio(1), 2*max (abs ([q, 0.1*v]))/1e-3, 1e-12);
%! assert (ratio(2) > ratio(1));  # beyond 1, t^5 has the lower powers, too
%!test # halved steps divide it by 32, and where stiffness holds a mass its velocity counts little
%! assert (of_powers (5, 0, 0.1)(1)/of_powers (5, 0, 0.05)(1), 32, 1e-6);
%! assert (of_powers (5, 1e9, 0.1, 0)(1) < 1e-5*of_powers (5, 0, 0.1, 0)(1));
