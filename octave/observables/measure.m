## -*- texinfo -*-
## @deftypefn {} {@var{history} =} measure (@var{system}, @var{model}, @var{times}, @var{states})
## What is observed at the frame times: a struct of 1-by-m rows t, phi, phi_dot, psi, tip_x, tip_y, T, U, Z, W, D, balance
## (T + U + Z + D - W, constant), and of the matrices V1 (N1-by-m), V2 (N2-by-m).
## @end deftypefn

function history = measure (system, model, times, states)
  n = system.n;
  history.t = times;
  history.phi = states(n+1,:);
  history.phi_dot = states(2*n+2,:);
  history.V1 = states(1:model.modes(1),:);
  history.V2 = states(model.modes(1)+1:n,:);
  [history.tip_x, history.tip_y] = centreline (model, model.length, history, 1);
  columns = num2cell (states, 1);
  history.psi = cellfun (system.tangent_angle, columns);
  E = cell2mat (cellfun (@(y) system.energies (y).', columns, "uniformoutput", false));
  [history.T, history.U, history.Z] = deal (E(1,:), E(2,:), E(3,:));
  history.W = states(end-1,:);
  history.D = states(end,:);
  history.balance = history.T + history.U + history.Z + history.D - history.W;
endfunction

%!test # a rigid rod at rest
%! scene = check_scene (setfield (paper (), "model", "modes", [0 0]));
%! model = build_model (scene);
%! history = measure (system = hinged_rod (scene, model), model, 0, system.initial_state);
%! assert ([history.tip_x, history.tip_y], [cos(pi/6), -0.5], 1e-12);
%! assert (history.psi, -pi/6, 1e-12);
%! assert (history.balance, -7800*0.02*0.03*9.81*0.25, 1e-12);
