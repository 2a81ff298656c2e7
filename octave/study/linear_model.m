## -*- texinfo -*-
## @deftypefn {} {[@var{model}, @var{scene}, @var{output}] =} linear_model (@var{scene}, @var{option}, @var{value}, @
##   @dots{})
## The equations of a scene of any kind linear about the equilibrium that it comes to (see @code{statics}, also for the
## arguments), with named inputs and outputs: a struct of M, C, G and K (p-by-p: M y'' + (C + G) y' + K y = F u; C
## symmetric, G skew), F, basis (n-by-p, of the coordinates q by y), omega (rad/s, of its vibrations), and of it as
## x' = A x + B u, z = C_out x + D u in the form that @code{ss (A, B, C_out, D)} of the control package takes.
##
## inputs (cellstr) are the components of forces and moments; of prescribed places and angles (driven) it is their
## acceleration (per s^2), and they and their rates are the last states, after y and y'; what moves the chart of a rod
## on a surface is none, which a warning says. outputs (cellstr) are columns
## of history.csv, measured from their values at rest (rest): the option "outputs" has their names without units, by
## default all of places and angles, "tip_*", "mid_*", "psi*", and reactions.  harmonic (s) is the outputs' answer to
## inputs that go as exp (s t), of what is prescribed by its place or angle (see @code{harmonic_response}).
## @var{scene} and @var{output} are those of @code{study_scene}.
##
## @example
## model = linear_model ("two_link_arm"); # sys = ss (model.A, model.B, model.C_out, model.D);
## @end example
## @end deftypefn

function [model, scene, output] = linear_model (scene = "paper", varargin)
  [time, options] = taken_time (varargin);
  [wanted, options] = wanted_outputs (options);
  [scene, kind, output] = study_scene (scene, options, @scene_at_rest);
  found = at_rest (kind, scene, time, @(found) found.vibrations.omega(1:min (end, 6)));
  cellfun (@(text) say ("warning: %s", text), slowly_converging (max (found.change), "a frequency by %.2g of itself"));
  [unit, model.inputs, model.driven] = unit_inputs (scene, time);
  moved = cellfun (@(name) ! isempty (field_or (scene, name, [])), {"rotation", "place"});
  cellfun (@(name) say ("warning: the %s is no input: it stays as at t = %g s", name, time), {"rotation", "place"}(moved));
  unit.duration = numel (model.inputs) + 1;
  rods = model_of (kind, unit, found.functions);
  [into, hold] = pushes (kind.at_rest (unit, rods), found, numel (model.inputs));
  [model.outputs, model.rest, by] = observed (kind, unit, rods, found, numel (model.inputs), wanted);
  model = with_matrices (model, found, into, hold, by);
  model.harmonic = @(s) harmonic_response (found, model.driven, into, hold, by, s);
  model.omega = found.vibrations.omega;
endfunction

function [wanted, options] = wanted_outputs (options)
  [options, taken] = without_options (options, "outputs");
  wanted = {};
  if (! isempty (taken))
    wanted = cellstr (taken{end});
  endif
endfunction

## what a unit of each input adds to the forces (n-by-m), and coordinates that follow where it is prescribed (n-by-m)
function [into, hold] = pushes (balance, found, inputs)
  all_of = repmat (found.q, 1, inputs + 1);
  r = balance.residual (0:inputs, all_of, 0*all_of, found.lambda);
  change = r(:,2:end) - r(:,1);
  into = change(1:balance.n,:);
  hold = -inverse_of (found.linear.jacobian)*change(balance.n+1:end,:);
endfunction

## outputs by q, v, lambda and u, and their values at rest
function [names, rest, by] = observed (kind, scene, rods, found, inputs, wanted)
  system = kind.system (scene, rods);
  n = found.balance.n;
  state = [found.q; 0*found.q; found.lambda];
  energies = zeros (numel (system.initial_state) - numel (state), 1);
  columns_of = @(numbers, states) table_of (kind, scene, rods, system, numbers, ...
                                            [states; energies(:,ones (1, columns (states)))]);
  [names, values] = columns_of (0:inputs, repmat (state, 1, inputs + 1));
  kept = kept_columns (names, wanted);
  names = names(kept);
  rest = values(kept,1);
  by.u = values(kept,2:end) - rest;
  unit = eye (n);
  steps = 1e-4*found.balance.length./arrayfun (@(k) found.balance.size (unit(:,k)), 1:n).';
  steps = [steps; steps; max(abs (found.lambda), 1)];
  change = @(x) nthargout (2, columns_of, zeros (1, columns (x)), state + x)(kept,:);
  D = difference_quotients (change, steps);
  by.q = D(:,1:n);
  by.v = D(:,n+1:2*n);
  by.lambda = D(:,2*n+1:end);
endfunction

function [names, table] = table_of (kind, scene, rods, system, numbers, states)
  run = kind.observe (scene, rods, system, numbers, states);
  run.model = rods;
  [names, table] = kind.columns (scene, run);
endfunction

function kept = kept_columns (names, wanted)
  plain = regexprep (names, ' \[.*', "");
  if (isempty (wanted))
    kept = find (! cellfun (@isempty, regexp (plain, '^(tip_|mid_|psi|reaction_|torque)', "once")));
    return;
  endif
  kept = [];
  for name = wanted(:).'
    at = find (strcmp (name{1}, plain), 1);
    if (isempty (at))
      scene_error ("outputs has \"%s\": history.csv has %s", name{1}, strjoin (plain, ", "));
    endif
    kept(end+1) = at;
  endfor
endfunction

%!function scene = sprung (force)   # a rod that a spring holds aslant against its weight, pulled at its end
%!  scene.rod = struct ("length", 1, "EA", 1e4, "EI", 20, "rhoA", 1, "half_height", 0.01);
%!  scene.model = struct ("modes", [0 1], "energy", "uniaxial", "rotary_inertia", false, "stiffening", "none");
%!  [scene.duration, scene.frames_per_second, scene.initial] = deal (1, 20, "equilibrium");
%!  scene.solver.tolerance = 1e-9;
%!  scene.joints = {struct("kind", "torsion_spring", "stations", 0, "stiffness", 30, "damping", 0.2), ...
%!                  struct("name", "push", "kind", "force", "stations", 1, "value", force)};
%!endfunction
%!function model = model_of_scene (scene, varargin)
%!  evalc ("model = linear_model (scene, 'output', tempdir (), varargin{:});");
%!endfunction
%!function [off, moved] = apart (size)   # of the tip under a growing force, from the linear model's
%!  model = model_of_scene (sprung ([0 0]), "outputs", {"tip_x_1", "tip_y_1"});
%!  run = driver (sprung (@(t) size*[t, 2*t]), "output", "");
%!  ramp = size*model.B*[1; 2];
%!  whole = expm ([model.A, ramp, 0*ramp; zeros(1, 5), 1; zeros(1, 6)]*run.history.t(end));
%!  z = model.rest + model.C_out*whole(1:4,6);
%!  moved = [run.history.tip_x(end); run.history.tip_y(end)];
%!  off = norm (z - moved);
%!  moved = norm (moved - model.rest);
%!endfunction
%!test # a run under a small load is that of the linear model, up to the second order
%! [large, moved] = apart (0.5);
%! small = apart (0.25);
%! assert (moved > 0.01); assert (large < 2*moved^2); assert (large/small, 4, 0.4);

%!test # a pendulum whose hinge is driven along x: (m l^2/3) phi'' + m g l/2 phi = -m l/2 x'', and what the drive takes
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", ...
%!                        struct ("modes", [0 0], "rotary_inertia", false), "initial", struct ("phi", -pi/2))};
%! scene.joints = {struct("name", "cart", "kind", "position", "bodies", 1, "stations", 0, "value", @(t) zeros (3, 2))};
%! scene.duration = 1;
%! model = model_of_scene (scene, "outputs", {"reaction_x_1", "tip_x_1", "phi_1"});
%! assert (model.inputs, {"cart_x [m]", "cart_y [m]"}); assert (columns (model.A), 6);
%! assert (model.K/model.M, 6*9.81/8, 1e-9);
%! H = @(s) model.C_out*((s*eye (6) - model.A) \ model.B) + model.D;
%! s = 2i; turn = -6*s^2/(8*s^2 + 6*9.81);  # phi by the cart's place
%! assert ((H (s)*[1; 0])(3)*s^2, turn, 1e-8);
%! assert ((H (s)*[1; 0])(2)*s^2, 1 + 2*turn, 1e-8);
%! assert ((H (s)*[1; 0])(1)*s^2, 6*s^2*(1 + turn), 1e-6);
%!error <outputs has "tip_q": history.csv has t, x_1, y_1> model_of_scene (sprung ([0 0]), "outputs", "tip_q");
%!test # what moves the chart is no input, which is said
%! scene = setfield (plane_rods ({"clamped", "free"}, [5 5]), "tip_moment", @(t) 0*t);
%! scene.rotation = @(t) [0 0 0];
%! said = evalc ("model = linear_model (scene, 'output', '', 'outputs', 'tip_y');");
%! assert (! isempty (strfind (said, "warning: the rotation is no input: it stays as at t = 0 s")));
%!test # of a rod on a surface: its static deflection under a force across its end, and no multipliers
%! scene = setfield (plane_rods ({"clamped", "free"}, [5 5]), "force", [0 0 0]);
%! model = model_of_scene (scene, "outputs", "tip_y");
%! assert (-model.C_out*(model.A \ model.B(:,2)), 1/3, 1e-9); assert (model.inputs{4}, "moment [N m]");
