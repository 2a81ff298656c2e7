## -*- texinfo -*-
## @deftypefn {} {@var{message} =} bad_scenes (@var{field}, @var{value})
## What is said of a scene that is good but for the @var{value} of this @var{field}.
## @end deftypefn

function message = bad_scenes (field, value)
  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.015), "duration", 1);
  path = strsplit (field, ".");
  message = "";
  try
    check_scene (setfield (scene, path{:}, value));
  catch err
    message = strtrim (err.message);
  end_try_catch
endfunction

%!function check (field, value, rest)
%!  assert (bad_scenes (field, value), [field " " rest]);
%!endfunction

%!test # numbers that must be positive
%! units = {"rod.length", "m"; "rod.width", "m"; "rod.half_height", "m"; "rod.mu", "Pa"; "rod.density", "kg/m^3"; ...
%!          "rod.EA", "N"; "rod.EI", "N m^2"; "rod.rhoA", "kg/m"; "duration", "s"; "frames_per_second", "1/s"};
%! for field = units.'
%!   for bad = {0, "0"; -1, "-1"; NaN, "NaN"; Inf, "Inf"; 2i, "0 + 2i"; [1 2], "1   2"; "one", "\"one\""; ...
%!              {}, "a 0-by-0 cell"}.'
%!     check (field{1}, bad{1}, sprintf ("is %s: it takes positive number in %s", bad{2}, field{2}));
%!   endfor
%! endfor

%!test # numbers that may be zero
%! units = {"rod.lambda", "Pa"; "rod.rhoI", "kg m"; "rod.damping", "s"; "tip_mass", "kg"; "force_station", "m"};
%! for field = units.'
%!   check (field{1}, -1, sprintf ("is -1: it takes nonnegative number in %s", field{2}));
%!   check (field{1}, NaN, sprintf ("is NaN: it takes nonnegative number in %s", field{2}));
%! endfor
%! check ("zoom", -2, "is -2: it takes nonnegative number");
%!test
%! check ("joints", 3, "is 3: it takes struct array, or cell array of structs");

%!test # a size in pixels
%! for bad = {[1280 721], "1280    721"; [1280 -720], "1280   -720"; 720, "720"; [10 10], "10   10"; ...
%!            "wide", "\"wide\""}.'
%!   check ("frame_size", bad{1}, ...
%!          sprintf ("is %s: it takes two even numbers of pixels from 320 to 8192 [W H]", bad{2}));
%! endfor

%!test # any number
%! for field = {"gravity", "m/s^2"; "initial.phi", "rad"; "initial.phi_dot", "rad/s"}.'
%!   check (field{1}, "up", sprintf ("is \"up\": it takes number in %s", field{2}));
%!   check (field{1}, -Inf, sprintf ("is -Inf: it takes number in %s", field{2}));
%! endfor

%!test # where a run may start
%! check ("initial.from", "nowhere", ["is \"nowhere\": it takes \"equilibrium\", or a folder in which a run has left" ...
%!                                    " its end.csv, output/paper say"]);

%!test # vectors
%! for field = {"moment_breaks", "times in s"; "breaks", "times in s"; "initial.V1", "amplitudes in m"
%!              "initial.V2", "amplitudes in m"; "initial.V1_dot", "rates in m/s"; "initial.V2_dot", "rates in m/s"}.'
%!   check (field{1}, [1 NaN], sprintf ("is 1   NaN: it takes vector of %s", field{2}));
%!   check (field{1}, eye (2), sprintf ("is a 2-by-2 double: it takes vector of %s", field{2}));
%! endfor

%! check ("rod.curvature_breaks", [1 NaN], "is 1   NaN: it takes vector of stations in m");

%!test # functions
%! check ("rod.curvature", "bent", "is \"bent\": it takes vector or function of xi in 1/m");
%! check ("rod.curvature", NaN, "is NaN: it takes vector or function of xi in 1/m");
%! check ("moment", "strong", "is \"strong\": it takes number or function of t in N m");
%! check ("moment", NaN, "is NaN: it takes number or function of t in N m");
%! check ("rotation", 3, "is 3: it takes function of t that returns [theta theta_dot theta_ddot]");
%! check ("force", [1 2], "is 1   2: it takes function of t that returns [F_x F_y] in N");
%! check ("rotation", @(t) [1 2], ...
%!        "gives [1 2] at t = 0: it takes 3 numbers, theta, theta_dot and theta_ddot in rad, rad/s and rad/s^2");
%! check ("force", @(t) [NaN 0], "gives [NaN 0] at t = 0: it takes 2 numbers, F_x and F_y in N");

%!test # choices and texts
%! check ("title", 3, "is 3: it takes text");
%! check ("model.modes", [1 2 3], "is 1   2   3: it takes \"auto\" or two numbers of modes [N1 N2]");
%! check ("model.modes", [-1 2], "is -1   2: it takes \"auto\" or two numbers of modes [N1 N2]");
%! check ("model.energy", "exact", "is \"exact\": it takes \"paper\" or \"uniaxial\"");
%! check ("model.axial", 1, "is 1: it takes \"auto\", \"dynamic\", \"quasistatic\" or \"none\"");
%! check ("model.stiffening", "yes", "is \"yes\": it takes \"auto\", \"foreshortening\" or \"none\"");
%! check ("model.moment_work", "both", "is \"both\": it takes \"tangent\" or \"chord\"");
%! check ("model.rotary_inertia", 2, "is 2: it takes true or false");
%! check ("solver.name", "magic", ...
%!        ["is \"magic\": it takes \"auto\", \"waveform\", \"exponential\", \"ode45\", \"ode23\", \"ode23s\"," ...
%!         " \"ode15s\", \"lsode_adams\", \"lsode_bdf\", \"rk4\", \"stormer_verlet\", \"implicit_midpoint\"," ...
%!         " \"generalized_alpha\" or \"trigonometric\""]);
%! check ("solver.step", 0, "is 0: it takes positive number in s");
%! check ("solver.rho_infinity", 2, "is 2: it takes number from 0 to 1");
%! check ("solver.tolerance", 0, "is 0: it takes \"pixel\" or positive number in m");

%!test # every field of the table has had its bad value above
%! text = fileread (which ("bad_scenes"));
%! for name = scene_fields ()(:,1).'
%!   assert (! isempty (strfind (text, ["\"" name{1} "\""])), name{1});
%! endfor
