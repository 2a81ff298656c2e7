## -*- texinfo -*-
## @deftypefn {} {@var{window} =} solve_window (@var{modal}, @var{t}, @var{z}, @var{h}, @var{panels}, @var{panel}, @
##   @var{scale})
## Solve z_dot = oscillation + remainder (see @code{modal_form}) from the time @var{t} (s) and the state @var{z} on,
## through so many @var{panels} of @var{h} (s) each, by waveform relaxation: the remainder at all nodes of all panels
## at once, then the oscillators under it, exactly, and again until a sweep changes less than a tenth of the
## @var{scale}, which is what (eta; w) may be off by.
##
## @var{panel} has the matrices of one panel: nodes (1-by-m, 0 to 1), free and forced at all nodes but the first (see
## @code{panel_response}), and defect (m-by-m), which leaves of values at the nodes (in a row) what polynomials of two
## degrees less do not have.  @var{window}: converged, errors (1-by-panels, estimates at the panels' ends, in units of
## the scale: as if the defect met every mode in resonance), starts (states where the panels begin and end,
## R-by-(panels + 1)), remainders ((R m)-by-panels), sweeps.
## @end deftypefn

function window = solve_window (modal, t, z, h, panels, panel, scale)
  R = rows (z);
  m = numel (panel.nodes);
  inner = reshape (panel.nodes(1:end-1).' + (0:panels-1), 1, []);
  times = t + h*[inner, panels];
  of_panel = (1:m).' + (m - 1)*(0:panels-1);
  in_scales = @(z) largest (sizes (modal, z)./scale);

  remainder = modal.remainder (t, z)(:,ones (1, numel (times)));
  starts = change = Inf;
  window.sweeps = 0;
  do
    if (window.sweeps > 0)
      remainder = modal.remainder (times, states);
    endif
    window.sweeps++;
    window.remainders = reshape (remainder(:,of_panel(:)), R*m, panels);
    forced = (window.remainders.'*panel.forced).';  # full times sparse: in this order it is fast
    window.starts = chained (panel.free(end-R+1:end,:), z, forced(end-R+1:end,:));
    states = [z, reshape((window.starts(:,1:end-1).'*panel.free.').' + forced, R, [])];
    last = change;
    change = largest (in_scales (window.starts - starts).');
    rate = max (change/last, 0.1);  # of convergence: the first changes shrink faster than the next ones
    window.converged = change < 1e-3 || (window.sweeps > 2 && change*rate <= 0.1*(1 - rate));
    hopeless = window.sweeps > 15 || (window.sweeps > 3 && ! (change < 0.7*last));
    starts = window.starts;
  until (window.converged || hopeless)
  window.errors = in_scales (defects_of (modal, remainder(:,of_panel(:)), h, panels, panel.defect));
endfunction

## of each column; max passes by what is no number
function x = largest (values)
  x = max (values, [], 1);
  x(any (isnan (values), 1)) = NaN;
endfunction

## each panel begins where the last one ended, by doubling
function starts = chained (free, z, forced)
  starts = [z, forced];
  reach = 1;
  while (reach < columns (starts))
    starts(:,reach+1:end) += free*starts(:,1:end-reach);
    free *= free;
    reach *= 2;
  endwhile
endfunction

## m: what the coordinates are off by at the panels' ends, R-by-panels
function z = defects_of (modal, remainders, h, panels, defect)
  R = rows (remainders);
  n = modal.n;
  m = rows (defect);
  by_nodes = reshape (permute (reshape (remainders, R, m, panels), [1 3 2]), R*panels, m)*defect;
  z = h*cumsum (reshape (max (abs (by_nodes), [], 2), R, panels), 2);
  z(1:n,:) += z(n+1:2*n,:)./max (modal.omega, 1/(h*panels));
endfunction

## by how much coordinates and what follows them may move centreline points
function metres = sizes (modal, z)
  n = modal.n;
  metres = [abs(modal.X)*abs(z(1:n,:)); abs(z(2*n+1:end,:))];
endfunction

%!test # x_ddot = -4 x - x^3/10 on two panels: as finely as another method has it
%! modal = struct ("n", 1, "omega", 2, "damping", 0, "X", 1, "remainder", @(t, z) [0*z(1,:); -z(1,:).^3/10]);
%! nodes = [0 0.15 0.5 0.85 1];
%! weights = inv (cos (acos (2*nodes.' - 1).*(0:4)));
%! panel = struct ("nodes", nodes, "defect", zeros (5));
%! [panel.free, panel.forced] = panel_response (modal, 0.1, nodes(2:end), weights, 0);
%! window = solve_window (modal, 0, [1; 0], 0.1, 2, panel, 1e-9);
%! options = odeset ("RelTol", 1e-11, "AbsTol", 1e-11);
%! [~, y] = ode45 (@(t, y) [y(2); -4*y(1) - y(1)^3/10], [0 0.1 0.2], [1; 0], options);
%! assert (window.converged);
%! assert (window.starts, y.', 1e-9);
%! modal.remainder = @(t, z) [0*z(1,:); -1e4*z(1,:)];  # sweeps that grow are given up
%! window = solve_window (modal, 0, [1; 0], 0.1, 2, panel, 1e-9);
%! assert ([window.converged, window.sweeps], [0 4]);
%! modal.remainder = @(t, z) [0*z(1,:); 0./(t <= 0.15); 0*z(1,:)];  # and what is no number, whatever only follows is
%! [panel.free, panel.forced] = panel_response (modal, 0.1, nodes(2:end), weights, 1);
%! window = solve_window (modal, 0, [1; 0; 0], 0.1, 2, panel, [1e-9; 1e-7]);
%! assert ([window.converged, window.sweeps], [0 4]); assert (isnan (window.errors), [false true]);
