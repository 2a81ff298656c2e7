## -*- texinfo -*-
## @deftypefn {} {@var{y_dot} =} literal_rod_rate (@var{t}, @var{y}, @var{scene}, @var{modes})
## The rate of the hinged rod's state (V; phi; V_dot; phi_dot), the paper's way: the equations of motion written out
## term by term for @var{modes} = [N1 N2] (N1, N2 > 0), which `make derive MODES="N1 N2"' has written.  It is the
## oracle for the general form and what its speed is measured against.
## @end deftypefn

function y_dot = literal_rod_rate (t, y, scene, modes)
  n = sum (modes);
  prefix = sprintf ("literal_%d_%d_", modes);
  motion = struct ("V1", y(1:modes(1)), "V2", y(modes(1)+1:n), "phi", y(n+1), ...
                   "V1_dot", y(n+1+(1:modes(1))), "V2_dot", y(n+1+(modes(1)+1:n)), "phi_dot", y(2*n+2));
  model = struct ("rotary_inertia", double (scene.model.rotary_inertia), ...
                  "paper_energy", double (strcmp (scene.model.energy, "paper")), ...
                  "tangent_work", double (strcmp (scene.model.moment_work, "tangent")));
  mass_matrix = feval ([prefix "mass_matrix"], motion, scene.rod, model);
  forces = feval ([prefix "generalized_forces"], motion, scene.rod, model, scene.gravity, scene.moment (t));
  y_dot = [y(n+2:2*n+2); mass_matrix \ forces];
endfunction

%!function worst = largest_difference (energy, moment_work, rotary_inertia, states)
%!  scene = paper (); scene.model.modes = [7 7];
%!  scene.model.energy = energy; scene.model.moment_work = moment_work; scene.model.rotary_inertia = rotary_inertia;
%!  scene.rod.damping = 1e-4; scene.rod.half_height = 0.15; scene.rod.lambda = 1.2e7; scene.rod.mu = 8e6;
%!  scene = check_scene (scene);
%!  model = build_model (scene, rung_of_scene (scene));
%!  system = hinged_rod (scene, model);
%!  worst = 0;
%!  for k = 1:states
%!    t = 0.29*rand (); y = [0.05*randn(14, 1)./(1:14).'; 6*rand(); randn(14, 1)./(1:14).'; 10*randn(); 0; 0];
%!    [~, p] = system.energies (y(15), y(30), y(1:14), y(16:29));
%!    general = system.rate (t, [y(1:29); p; 0; 0])(1:29);
%!    literal = literal_rod_rate (t, y, scene, [7 7])(1:29);
%!    worst = max (worst, norm (general - literal)/norm (literal));
%!  endfor
%!endfunction

%!test # literal and general forms agree at 100 random states, in each variant
%! rand ("twister", 1); randn ("twister", 1);
%! assert (largest_difference ("paper", "tangent", true, 40) < 1e-10);
%! assert (largest_difference ("paper", "chord", false, 20) < 1e-10);
%! assert (largest_difference ("uniaxial", "tangent", false, 20) < 1e-10);
%! assert (largest_difference ("uniaxial", "chord", true, 20) < 1e-10);
