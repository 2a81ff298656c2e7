## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_waveform (@var{system}, @var{times}, @var{y}, @var{solver})
## Exponential waveform relaxation through all @var{times} (1-by-m, s) from the state @var{y}: the oscillation of the
## linear modes (see @code{modal_form}) is exact, what is left is a polynomial of degree 7 on each panel, and many
## panels, a window, are solved at once by @code{solve_window} (waveform relaxation: Lelarasmee, Ruehli and
## Sangiovanni-Vincentelli, IEEE Trans. CAD 1, 1982; exponential quadrature: Hochbruck and Ostermann, Acta Numerica 19,
## 2010).  @var{system}.rate (t, y) takes many times at once, which is what makes it fast here.
##
## Panels shrink until polynomials of degree 6 would do, to the window's share of @var{solver}.tolerance, in units of
## system.state_scale; of a window that is off by more, the first panels are kept that are not.  Windows have fewer
## panels where the relaxation converges slowly.  Panels that shrink to nothing are an error that says where.
## @var{steps}: the number of panels.
## @end deftypefn

function [states, steps] = integrate_waveform (system, times, y, solver)
  persistent rule = panel_rule (8);
  n = rows (system.mass);
  extra = numel (y) - 2*n;
  ## what only follows may be off by more
  scale = solver.tolerance*[system.state_scale(1:n); 100*system.state_scale(2*n+1:end)];
  states = repmat (y, 1, numel (times));
  [t, last_time] = deal (times(1), times(end));
  [h, most, steps, modal] = deal ((last_time - t)/100, 16, 0, []);
  while (t < last_time)
    if (isempty (modal))
      modal = modal_form (system, system.stiffness_at (t, y));
      z = modal.form (y);
    endif
    to_go = ceil ((last_time - t)/h*(1 - 1e-9));
    panels = min (to_go, most);
    if (panels == to_go)
      h = (last_time - t)/panels;
    endif
    frames = frames_inside (times, t, h, panels);
    [panel, frames] = responses (modal, h, rule, frames, extra);
    window = solve_window (modal, t, z, h, panels, panel, scale);
    ratios = window.errors./max (h/system.duration*(1:panels), 0.1);
    kept = 0;
    if (window.converged)
      kept = find ([true, ratios <= 1], 1, "last") - 1;
    endif
    if (kept > 0)
      steps += kept;
      states(:,frames.index(frames.panel <= kept)) = states_inside (modal, window, frames, kept);
      t = [t + kept*h, last_time](1 + (kept == to_go));
      y = modal.state (window.starts(:,kept+1));
      modal = [];
    endif
    if (! window.converged)
      [most, h] = deal (ceil (panels/4), h/(1 + 3*(panels == 1)));
    elseif (kept == panels)
      most = min (most*(1 + (window.sweeps < 7)), 128);
      h *= min (2, 0.9*max (ratios(end)*most/panels, realmin)^(-1/8));
    else
      h *= max (0.1, min (0.8, 0.9*ratios(end)^(-1/8)));
    endif
    if (! (h > 1e-12*last_time))
      stop_integration ("waveform", system, t, last_time, h, "its panels shrank to nothing", ...
                        sprintf ("a larger tolerance than %.2g m", solver.tolerance));
    endif
  endwhile
endfunction

## index in the times, number of the panel and fraction of it
function frames = frames_inside (times, t, h, panels)
  frames.index = find (times > t & times <= t + panels*h*(1 + 1e-12));
  at = (times(frames.index) - t)/h;
  frames.panel = max (ceil (at - 1e-9), 1);
  frames.fraction = at - frames.panel + 1;
endfunction

## free and forced, at the nodes and at the frames
function [panel, frames] = responses (modal, h, rule, frames, extra)
  [free, forced] = panel_response (modal, h, [rule.nodes(2:end), frames.fraction], rule.weights, extra);
  at_nodes = columns (free)*(numel (rule.nodes) - 1);
  panel = setfield (setfield (rule, "free", free(1:at_nodes,:)), "forced", forced(:,1:at_nodes));
  [frames.free, frames.forced] = deal (free(at_nodes+1:end,:), forced(:,at_nodes+1:end));
endfunction

function states = states_inside (modal, window, frames, kept)
  R = rows (window.starts);
  states = zeros (R, sum (frames.panel <= kept));
  for i = 1:columns (states)
    [here, k] = deal ((i - 1)*R + (1:R), frames.panel(i));
    states(:,i) = frames.free(here,:)*window.starts(:,k) + frames.forced(:,here).'*window.remainders(:,k);
  endfor
  states = modal.state (states);
endfunction

## Chebyshev's points of 0 to 1, ends included
function rule = panel_rule (m)
  angles = pi*(0:m-1)/(m - 1);
  rule.nodes = (1 - cos (angles))/2;
  chebyshev = cos ((0:m-1).'.*(pi - angles));  # a row a degree
  rule.weights = inv (chebyshev.');
  rule.defect = inv (chebyshev)*diag ([zeros(1, m-1), 1])*chebyshev;
endfunction

%!test # oscillations beyond the panels are exact, the load is integrated to the tolerance
%! system = driven_oscillators ();
%! [states, steps] = integrate_waveform (system, [0 1 2.5 4], zeros (7, 1), struct ("tolerance", 1e-9));
%! w = [3; 1000];
%! for k = 2:4
%!   t = [0 1 2.5 4](k);
%!   assert (states(1:3,k), [1 - cos(t); (cos (t) - cos (t*w))./(w.^2 - 1)], 1e-9);
%!   assert (states(7,k), sin (t), 1e-9);
%! endfor
%! assert (steps < 100);
%!test # an error of the order of the tolerance: a pendulum, as its elliptic function has it
%! system = struct ("mass", 1, "stiffness_at", @(t, y) 1, "state_scale", [1; 1], "duration", 10, ...
%!                  "velocity_matrix", 1, "initial_state", [0; 0], "rate", @(t, y) [y(2,:); -sin(y(1,:))]);
%! k = 0.8;
%! exact = @(t) 2*asin (k*ellipj (t, k^2));
%! for tolerance = [1e-4 1e-7 1e-10 1e-13]
%!   states = integrate_waveform (system, 0:10, [0; 2*k], struct ("tolerance", tolerance));
%!   assert (states(1,:), exact (0:10), 10*tolerance);
%! endfor
%!error <waveform stopped at t = (0.99|1)\d* s of 2 s: its panels shrank to nothing: .* try a larger tolerance than 1e-06 m>
%! system = struct ("mass", 1, "stiffness", 0, "stiffness_at", @(t, y) 0, "duration", 2, "state_scale", [1; 1], ...
%!                  "velocity_matrix", 1, "initial_state", [1; 1], "rate", @(t, y) [y(2,:); 2*y(1,:).^3]);
%! integrate_waveform (system, [0 2], [1; 1], struct ("tolerance", 1e-6));
