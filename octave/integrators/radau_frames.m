## -*- texinfo -*-
## @deftypefn {} {@var{frames} =} radau_frames (@var{rule}, @var{window}, @var{before}, @var{h}, @var{t})
## States at the times @var{t} (1-by-m, s) within a @var{window} (see @code{radau_window}) of panels of @var{h} (s)
## from the state @var{before} on, a struct of q, v, lambda, W, D (a column a time), from its polynomials.
## @end deftypefn

function frames = radau_frames (rule, window, before, h, t)
  s = numel (rule.c);
  panel = max (1, ceil ((t - before.t)/h - 1e-9));
  x = (t - before.t)/h - panel + 1;
  of_panels = @(cells) cellfun (@(x) x(:,panel), cells, "uniformoutput", false);
  through = ((x.'.^(0:s))/([0; rule.c.'].^(0:s))).';
  of_stages = ((x.'.^(0:s-1))/(rule.c.'.^(0:s-1))).';
  frames.q = weighted ([{window.q_start(:,panel)}, of_panels(window.q)], through);
  frames.v = weighted ([{window.v_start(:,panel)}, of_panels(window.v)], through);
  frames.lambda = weighted (of_panels (window.lambda), of_stages);
  integrals = ((x.'.^(1:s)./(1:s))/(rule.c.'.^(0:s-1)));
  for name = {"power", "dissipated"; "W", "D"}
    rate = window.(name{1});
    sums = [0; cumsum(rate*rule.A(s,:).')](panel);
    frames.(name{2}) = before.(name{2}) + h*(sums + sum (rate(panel,:).*integrals, 2)).';
  endfor
endfunction

function sum = weighted (cells, weights)
  sum = zeros (rows (cells{1}), columns (weights));
  for k = 1:numel (cells)
    sum += cells{k}.*weights(k,:);
  endfor
endfunction

%!test # a frame within a panel: on its constraints, and where a finer integration has it
%! [system, start] = sample_mechanism ([0 1]);
%! states = integrate_radau (system, [0 0.0137 0.05], start, struct ("tolerance", 1e-4));
%! finer = integrate_radau (system, [0 0.0137], start, struct ("tolerance", 1e-8));
%! assert (states.q(:,2), finer.q(:,2), 2e-4);
%! assert ([states.W(2), states.D(2)], [finer.W(2), finer.D(2)], -1e-3); assert (states.D(2) > 0);
%! assert (states.v(:,2), finer.v(:,2), 1e-2*norm (finer.v(:,2)));
%! assert (states.lambda(:,2), finer.lambda(:,2), 1e-2*norm (finer.lambda(:,2)));
%! at = system.at (0.0137, states.q(:,2), states.v(:,2));
%! assert (abs (at.constraints.residual) < 1e-10); assert (abs (at.constraints.velocity) < 1e-8);
