## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_waveform (@var{system}, @var{times}, @var{y}, @var{solver})
## Exponential waveform relaxation through all @var{times} (1-by-m, s) from the state @var{y}: the oscillation of the
## linear modes (see @code{modal_form}) is exact, what is left is a polynomial of degree 7 on each panel, and many
## panels, a window, are solved at once by @code{solve_window} (waveform relaxation: Lelarasmee, Ruehli and
## Sangiovanni-Vincentelli, IEEE Trans. CAD 1, 1982; exponential quadrature: Hochbruck and Ostermann, Acta Numerica 19,
## 2010).  @var{system}.rate (t, y) takes many times at once, which is what makes it fast here.
##
## Panels shrink until polynomials of degree 6 would do, to the window's share of @var{solver}.tolerance, in units of
## system.state_scale; of a window that is off by more, the first panels are taken that are not.  Windows have fewer
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
  t = times(1);
  last_time = times(end);
  h = (last_time - t)/100;
  most_panels = 16;
  steps = 0;
  modal = [];
  while (t < last_time)
    if (isempty (modal))
      modal = modal_form (system, system.stiffness_at (t, y));
      z = modal.form (y);
    endif
    panels_to_go = ceil ((last_time - t)/h*(1 - 1e-9));
    panels = min (panels_to_go, most_panels);
    if (panels == panels_to_go)
      h = (last_time - t)/panels;
    endif
    frames = frames_inside (times, t, h, panels);
    [panel, frames] = responses (modal, h, rule, frames, extra);
    window = solve_window (modal, t, z, h, panels, panel, scale);
    ratios = window.errors./max (h/system.duration*(1:panels), 0.1);
    taken = 0;
    if (window.converged)
      taken = find ([true, ratios <= 1], 1, "last") - 1;
    endif
    if (taken > 0)
      steps += taken;
      states(:,frames.index(frames.panel <= taken)) = states_inside (modal, window, frames, taken);
      t += taken*h;
      if (taken == panels_to_go)
        t = last_time;
      endif
      y = modal.state (window.starts(:,taken+1));
      refuse_steep (system, solver, t, y);
      modal = [];
    endif
    [h, most_panels] = next_window (h, most_panels, panels, taken, window, ratios(end));
    if (! (h > 1e-12*last_time))  # or no number
      refuse_steep (system, struct ("steepest", 1), t, y);
      stop_integration ("waveform", system, t, h, "its panels shrank to nothing", ...
                        sprintf ("a larger tolerance than %.2g m", solver.tolerance));
    endif
  endwhile
endfunction

## length of the panels and how many there may be, after some of so many panels were taken; the ratio of the last
## panel's error to what it may be
function [h, most_panels] = next_window (h, most_panels, panels, taken, window, ratio)
  if (! window.converged)
    most_panels = ceil (panels/4);
    if (panels == 1)
      h /= 4;
    endif
  elseif (taken < panels)
    h *= max (0.1, min (0.8, 0.9*ratio^(-1/8)));
  else
    if (window.sweeps < 7)
      most_panels = min (2*most_panels, 128);
    endif
    h *= min (2, 0.9*max (ratio*most_panels/panels, realmin)^(-1/8));
  endif
endfunction

## index in the times, number of the panel and fraction of it
function frames = frames_inside (times, t, h, panels)
  frames.index = find (times > t & times <= t + panels*h*(1 + 1e-12));
  panels_from_t = (times(frames.index) - t)/h;
  frames.panel = max (ceil (panels_from_t - 1e-9), 1);
  frames.fraction = panels_from_t - frames.panel + 1;
endfunction

## free and forced, at the nodes and at the frames
function [panel, frames] = responses (modal, h, rule, frames, extra)
  [free, forced] = panel_response (modal, h, [rule.nodes(2:end), frames.fraction], rule.weights, extra);
  of_nodes = columns (free)*(numel (rule.nodes) - 1);
  panel = rule;
  panel.free = free(1:of_nodes,:);
  panel.forced = forced(:,1:of_nodes);
  frames.free = free(of_nodes+1:end,:);
  frames.forced = forced(:,of_nodes+1:end);
endfunction

## at the frames in the panels that are taken
function states = states_inside (modal, window, frames, taken)
  R = rows (window.starts);
  panel = frames.panel(frames.panel <= taken);
  of_frames = 1:R*numel (panel);
  of_panel = panel(ceil (of_frames/R));
  states = sum (frames.free(of_frames,:).*window.starts(:,of_panel).', 2) ...
           + sum (frames.forced(:,of_frames).*window.remainders(:,of_panel), 1).';
  states = reshape (full (states), R, []);
  states = modal.state (states);
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
%!test # a blow that lasts a hundredth of the run is not passed over: x'' + x = exp (-((t - c)/d)^2)
%! [c, d] = deal (2.9, 0.05);  # between the nodes of a panel as long as the run
%! system = struct ("mass", 1, "stiffness_at", @(t, y) 1, "state_scale", [1; 1], "duration", 10, ...
%!                  "velocity_matrix", 1, "initial_state", [0; 0]);
%! system.rate = @(t, y) [y(2,:); exp(-((t - c)/d).^2) - y(1,:)];
%! states = integrate_waveform (system, 0:5:10, [0; 0], struct ("tolerance", 1e-8));
%! assert (states(1,2:3), d*sqrt (pi)*exp (-d^2/4)*sin ([5 10] - c), 1e-7);
%!error <waveform stopped at t = (0.99|1)\d* s of 2 s: its panels shrank to nothing: .* try a larger tolerance than 1e-06 m>
%! system = struct ("mass", 1, "stiffness", 0, "stiffness_at", @(t, y) 0, "duration", 2, "state_scale", [1; 1], ...
%!                  "velocity_matrix", 1, "initial_state", [1; 1], "rate", @(t, y) [y(2,:); 2*y(1,:).^3]);
%! integrate_waveform (system, [0 2], [1; 1], struct ("tolerance", 1e-6));
