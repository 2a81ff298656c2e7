## -*- texinfo -*-
## @deftypefn {} {@var{system} =} hinged_rod (@var{scene}, @var{model})
## The hinged rod as a system of first order, y_dot = rate (t, y, interval), with the state
## y = (V; phi; V_dot; phi_dot; W; D): amplitudes, rotation, their rates, work of the moment, dissipated energy.
##
## Fields: n (modes), initial_state, rate, energies (y) = [T U Z], tangent_angle (y), breaks (times in s at which the load
## jumps) and state_scale, what each state may be off by where a centreline point is off by 1 m.
## @end deftypefn

function system = hinged_rod (scene, model)
  n = sum (model.modes);
  arrays = model.arrays;
  constants = arrays;
  constants.inverse_mass_matrix = inv (arrays.mass_matrix);
  constants.gravity = scene.gravity;
  constants.damping = scene.rod.damping;
  constants.moment = scene.moment;
  works_on_tangent = strcmp (scene.model.moment_work, "tangent");
  constants.slope_1 = works_on_tangent*model.slope_1;
  constants.slope_2 = works_on_tangent*model.slope_2;

  system.n = n;
  system.initial_state = initial_state (scene.initial, model.modes);
  system.rate = @(t, y, interval) hinged_rod_rate (t, y, interval, n, constants);
  system.energies = @(y) energies (y, n, constants);
  system.tangent_angle = @(y) rod_tangent_angle (y(n + 1), y(1:n), model.slope_1, model.slope_2);
  system.breaks = scene.moment_breaks;
  system.state_scale = state_scale (arrays, scene, model.length);
endfunction

function y = initial_state (initial, modes)
  V = [padded(initial.V1, modes(1), "V1"); padded(initial.V2, modes(2), "V2")];
  V_dot = [padded(initial.V1_dot, modes(1), "V1_dot"); padded(initial.V2_dot, modes(2), "V2_dot")];
  y = [V; initial.phi; V_dot; initial.phi_dot; 0; 0];
endfunction

function amplitudes = padded (given, n, name)
  if (numel (given) > n)
    scene_error ("initial.%s has %d amplitudes: the model has %d such modes", name, numel (given), n);
  endif
  amplitudes = [given(:); zeros(n - numel (given), 1)];
endfunction

function E = energies (y, n, c)
  [T, U, Z] = rod_energies (y(n+1), y(2*n+2), y(1:n), y(n+2:2*n+1), c.mass_matrix, c.gyroscopic_matrix, ...
                            c.coupling_vector, c.centrifugal_vector, c.moment_of_inertia, c.stiffness_matrix, ...
                            c.gravity, c.static_moment, c.first_moment_1, c.first_moment_2);
  E = [T U Z];
endfunction

## A rate is off by its amplitude times the lowest frequency. (At its own frequency, a stiff mode that ode45 takes at its
## limit of stability may carry an energy of 1e-3 of the largest.) The rotation's rate acts over the whole duration, and an
## energy is off by what the loads and the inertia do over the length.
function scale = state_scale (arrays, scene, length)
  frequency = sqrt (diag (arrays.stiffness_matrix)./diag (arrays.mass_matrix));
  amplitude = ones (size (frequency));
  moments = [arrays.moment_of_inertia/scene.duration^2, arrays.static_moment*abs(scene.gravity), ...
             abs(scene.moment (linspace (0, scene.duration, 1000)))];
  energy = max (moments)/length;
  scale = [amplitude; 1/length; min(frequency)*amplitude; 1/(length*scene.duration); energy; energy];
endfunction

%!test # at rest and undeformed: the rod falls as a rigid one begins to
%! scene = check_scene (paper ());
%! scene.model.modes = [0 0];
%! system = hinged_rod (scene, build_model (scene));
%! y_dot = system.rate (1, system.initial_state, [0.3 1.8]);
%! J = 7800*6e-4/3 + 7800*0.02*2*0.015^3/3; S = 7800*6e-4/2;
%! assert (y_dot(2), -9.81*S*cos (pi/6)/J, 1e-12*9.81*S/J);

%!error <initial.V2 has 8 amplitudes: the model has 7 such modes>
%! scene = check_scene (setfield (paper (), "initial", "V2", ones (1, 8)));
%! hinged_rod (scene, build_model (scene));
