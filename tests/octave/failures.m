## Runs that fail say so, with the time, the method and the cause in numbers; those that other rod programs let pass.

%!function run (scene, name, step, modes, varargin)
%!  scene = setfield (setfield (scene, "model", "modes", modes), "solver", ...
%!                    struct ("name", name, "tolerance", 1e-6, "step", step, varargin{:}));
%!  driver (scene, "output", "");
%!endfunction

%!error <stormer_verlet stopped at t = .* s of 1.8 s: (then its state is no number|its Newton .*): a step of .* times the highest frequency, .* is 2.05 where the method is stable below 2; try steps below>
%! run (paper (), "stormer_verlet", 2.05/2.0447e5, [7 7]);   # an explicit code inside its own rule: a tip at 1274 m
%!error <rk4 stopped at t = .* s of 1.8 s: then its state is no number: .* is 4.* where the method is stable below 2.828>
%! run (paper (), "rk4", 2e-5, [7 7]);
%!error <generalized_alpha stopped at t = 0.3 s of 1.8 s: its Newton iteration did not converge: a step of 0.01 s .*; try a shorter step>
%! run (paper (), "generalized_alpha", 1e-2, [7 7], "rho_infinity", 1);
%!error <lsode_bdf stopped at t = .*: the energy balance is off by .* of what changes, more than 0.05>
%! run (paper (), "lsode_bdf", [], [1 3], "tolerance", 0.1);
%!error <ode45 stopped at t = .*: the energy balance is off by .* where the method is stable below 0.9972>
%! run (paper (), "ode45", [], [0 3], "tolerance", 10);
%!error <rk4 stopped at t = 0 s of 1.8 s: it would take 3e\+11 steps, more than 1e8> run (paper (), "rk4", 1e-12, [0 1]);

%!test # half a step of 90 N m moves no tip: the break lies inside the steps of both, and the error is of order h^2
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 2]), "moment_breaks", 0.02997));
%! scene.moment = @(t) 3000*t.*(t < 0.02997);
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! solver = @(name, h) struct ("name", name, "tolerance", 1e-9, "step", h, "rho_infinity", 1);
%! at = @(name, h) integrate (system, [0 0.04], solver (name, h))(1:3,2);
%! reference = at ("waveform", []);
%! for name = {"implicit_midpoint", "stormer_verlet", "generalized_alpha"}
%!   assert (at (name{1}, 1e-4), reference, 1e-4);
%! endfor

%!test # the trapezoidal rule at 1e-3 s, which put the tip of a rod of 1 m 3 m away: here it and its energy stay
%! scene = setfield (setfield (paper (), "model", "modes", [7 7]), "solver", ...
%!                   struct ("name", "generalized_alpha", "tolerance", 1e-6, "step", 1e-3, "rho_infinity", 1));
%! history = driver (setfield (scene, "duration", 0.6), "output", "").history;
%! assert (hypot (history.tip_x, history.tip_y), ones (1, 31), 1e-3);

%!test # a Newton iteration as tight as rounding allows does not shorten its steps: their number is what was asked for
%! scene = setfield (setfield (paper (), "model", "modes", [7 7]), "solver", ...
%!                   struct ("name", "implicit_midpoint", "tolerance", 1e-6, "step", 1e-3));
%! assert (driver (setfield (scene, "duration", 0.2), "output", "").summary.steps, 200);

%!test # a failure reaches summary.json, and leaves the rest of the last good run
%! [folder, gone] = scratch_folder ();
%! solver = struct ("name", "rk4", "tolerance", 1e-6, "step", 0.02);
%! scene = setfield (setfield (paper (), "model", "modes", [0 1]), "solver", solver);
%! try, driver (scene, "output", folder); catch, end_try_catch
%! summary = jsondecode (fileread (fullfile (folder, "summary.json")));
%! message = summary.last_failure.message;
%! assert (! isempty (regexp (message, "^rk4 stopped at t = .* stable below 2.828; try steps below")));
