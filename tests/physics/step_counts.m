## What the integrators take for motions that are always the same: a change that makes one slower, or lets it pass over
## its tolerance, shows in its steps and calls where results stay within their tolerances.  Held are
## integrate_waveform, solve_window, panel_response, panel_integrals, integrate_exponential, turned_form, modal_form,
## integrate_explicit, integrate_ode15s, integrate_lsode, integrate_fixed, rk4, stormer_verlet, implicit_midpoint,
## generalized_alpha, trigonometric, integrate_radau, radau_window, radau_step, radau_factors, radau_guess,
## radau_frames, radau_plan, radau_whole_step, radau_rule, radau_matrix, radau_solve, integrate_gauss, collocation,
## collocation_stages, integrate_radau_residual, between_breaks, highest_frequency, stability_limit,
## integrator_table, integrate, momenta_of_rod, accelerations_of_rod, hinged_rod, alpha_coefficients,
## oscillator_roots, oscillator_functions, exponential_step, phi_functions, stumpff, surface_rod, quasi_stationary
## and stays.

%!function hold_counts (system, times, table)
%!  for row = table.'
%!    [name, tolerance, steps, calls] = row{:};
%!    solver = struct ("name", name, "tolerance", tolerance, "step", [], "rho_infinity", 0.8);
%!    [~, count] = integrate (system, times, solver);
%!    assert ([count.steps, count.calls], [steps, calls], -0.02);
%!  endfor
%!endfunction
%!test # a rod with three bending modes
%! [scene, model] = sample_rod ([0 3], "duration", 0.1);
%! hold_counts (hinged_rod (scene, model), [0 0.015 0.05], {
%!   "waveform",          1e-4, 53,  751
%!   "waveform",          1e-8, 60,  1272
%!   "exponential",       1e-4, 10,  46
%!   "ode45",             1e-4, 201, 1206
%!   "lsode_adams",       1e-4, NaN, 686
%!   "lsode_bdf",         1e-4, NaN, 264
%!   "rk4",               1e-4, 371, 1484
%!   "stormer_verlet",    1e-4, 524, 3406
%!   "implicit_midpoint", 1e-4, 300, 1200
%!   "generalized_alpha", 1e-4, 300, 1247
%!   "trigonometric",     1e-4, 300, 2136});
%!testif HAVE_SUNDIALS # the same by SUNDIALS
%! [scene, model] = sample_rod ([0 3], "duration", 0.1);
%! hold_counts (hinged_rod (scene, model), [0 0.015 0.05], {"ode15s", 1e-4, NaN, 605});
%!test # one with all modes, of a material that dissipates
%! scene = check_scene (setfield (setfield (damped (), "duration", 0.1), "model", "modes", [1 2]));
%! hold_counts (hinged_rod (scene, build_model (scene, rung_of_scene (scene))), [0 0.015 0.05], {
%!   "waveform",    1e-4, 53,  751
%!   "waveform",    1e-8, 70,  989});
%!test # a mechanism
%! [system, start] = sample_mechanism ([0 1]);
%! system.initial_state = stacked_rows (setfield (start, "lambda", zeros (system.constraint_count, 1)));
%! system.state_scale = system.q_scale;
%! hold_counts (system, [0 0.015 0.05], {
%!   "radau", 1e-4, 30, 517
%!   "radau", 1e-8, 30, 654});
%!test # a rod on a surface
%! scene = check_surface_scene (setfield (setfield (large_swing (), "duration", 0.3), "model", "modes", [4 4]));
%! hold_counts (surface_rod (scene), [0 0.1 0.3], {
%!   "gauss", 1e-4, 105, 1112
%!   "gauss", 1e-7, 213, 2016
%!   "radau", 1e-4, 24,  511
%!   "radau", 1e-7, 51, 1011});
%!function evaluations = of_shaken (tolerance)   # a rod on a torus by Radau's method, evaluations a step
%!  scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 0.1, ...
%!                  "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "GJ", 0.3, "rhoA", 2), ...
%!                  "ends", {{"hinge", "free"}}, "model", struct ("modes", [4 4]), "initial", struct ("angle", 1), ...
%!                  "tip_moment", @(t) 0.02*sin (2000*t));
%!  system = surface_rod (check_surface_scene (setfield (scene, "solver", "tolerance", 1e-9)));
%!  seen = containers.Map ("evaluations", 0);
%!  residual = system.residual;
%!  system.residual = @(varargin) counted (seen, residual (varargin{:}));
%!  [~, count] = integrate (system, [0 0.1], struct ("name", "radau", "tolerance", tolerance));
%!  evaluations = seen("evaluations")/count.steps;
%!endfunction
%!function R = counted (seen, R)
%!  seen("evaluations")++;
%!endfunction
%!test # few steps are solved one by one, many short ones eight at once
%! assert (of_shaken (1e-8) > 3);
%! assert (of_shaken (1e-10) < 1);
