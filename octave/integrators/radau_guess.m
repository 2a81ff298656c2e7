## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{v}] =} radau_guess (@var{system}, @var{rule}, @var{window}, @var{y}, @var{h}, @
##   @var{kept}, @var{t})
## A first guess of coordinates and rates at the stages @var{t} (1-by-k, s) of the panels that follow the @var{kept}
## ones of a @var{window} (see @code{radau_window}) of panels of @var{h} (s), which ended with the state @var{y}.
##
## For one panel it is the last one's polynomials.  For more, bodies move on as the straight line that is nearest to
## their velocities in the window has it, which leaves out what rings; their deformations, which Newton's iteration
## finds at once, stay.
## @end deftypefn

function [q, v] = radau_guess (system, rule, window, y, h, kept, t)
  s = numel (rule.c);
  if (numel (t) == s)
    basis = ((1 + (t - y.t)/h).'.^(0:s)/[0; rule.c.'].^(0:s)).';
    of = @(start, stages) [start(:,kept), cellfun(@(x) x(:,kept), stages, "uniformoutput", false){:}]*basis;
    q = of (window.q_start, window.q);
    v = of (window.v_start, window.v);
    return;
  endif
  span = kept*h;
  since = reshape ((0:kept-1).' + rule.c, 1, [])/kept - 1;
  v = cellfun (@(v) v(:,1:kept), window.v, "uniformoutput", false);
  line = full (! any (system.stiffness, 2)).*([v{:}]/since.^[0; 1]);
  x = (t - y.t)/span;
  q = y.q + line*(x.^[1; 2].*[span; span/2]);
  v = line*x.^[0; 1];
endfunction

%!function window = of_motion (rule, at, at_dot, panels)   # from t = 1 to t = 1.4
%!  h = 0.4/panels;
%!  stages = num2cell (1 + h*((0:panels-1).' + rule.c), 1);
%!  window.q = cellfun (@(t) at (t.'), stages, "uniformoutput", false);
%!  window.v = cellfun (@(t) at_dot (t.'), stages, "uniformoutput", false);
%!  window.q_start = at (1 + h*(0:panels-1));
%!  window.v_start = at_dot (1 + h*(0:panels-1));
%!endfunction
%!test # what moves evenly accelerated goes on so, and what deforms stays
%! rule = radau_rule (3);
%! at = @(t) [t.^2; sin(50*t)]; at_dot = @(t) [2*t; 50*cos(50*t)];
%! system.stiffness = sparse (diag ([0 9]));
%! y = struct ("t", 1.4, "q", [1.4^2; 0.3]);
%! t = 1.4 + [0.1 0.2 0.3 0.4];
%! [q, v] = radau_guess (system, rule, of_motion (rule, at, at_dot, 2), y, 0.2, 2, t);
%! assert (q, [t.^2; 0.3*ones(1, 4)], 1e-12); assert (v, [2*t; 0*t], 1e-12);
%!test # of one panel: the polynomial
%! rule = radau_rule (3);
%! at = @(t) [t.^2; t.^3]; at_dot = @(t) [2*t; 3*t.^2];
%! system.stiffness = sparse (2, 2);
%! t = 1.4 + 0.4*rule.c;
%! [q, v] = radau_guess (system, rule, of_motion (rule, at, at_dot, 1), struct ("t", 1.4), 0.4, 1, t);
%! assert (q, at (t), 1e-12); assert (v, at_dot (t), 1e-12);
