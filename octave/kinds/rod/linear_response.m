## -*- texinfo -*-
## @deftypefn {} {[@var{response}, @var{phi_dot}] =} linear_response (@var{scene}, @var{model}, @var{rigid})
## How the eigenmodes of a @var{model} answer the loads along the motion of the @var{rigid} model, each by itself.
##
## @var{response}: omega (n-by-1, rad/s), and, as the largest displacements of centreline points that they cause
## (n-by-1, m), largest, and beyond_static, of what is left after the static deflection by the load of the moment.
## @var{phi_dot} (rad/s) is the rigid rod's, at the times looked at.
## @end deftypefn

function [response, phi_dot] = linear_response (scene, model, rigid)
  [times, inside] = fine_times (scene);
  [phi, phi_dot] = rigid_motion (scene, rigid, times);
  system = rod_system (scene, model);
  n = columns (model.basis);
  constants = rod_constants (scene, model);
  a = model.arrays;
  phi_of_q = -a.coupling_vector/a.moment_of_inertia;
  prescribed = [];
  if (! isempty (scene.rotation))
    phi_of_q = prescribed = -a.slope_2;
  endif
  P = [eye(n); phi_of_q.'];
  mass = diag (P.'*mass_with_rotation (a)*P);
  omega = sqrt (diag (a.stiffness_matrix)./mass);

  none = zeros (n, 1);
  loads = zeros (n, numel (times));
  for k = 1:numel (times)
    [m, mm, force_V, force_phi] = rod_forces (inside(k), phi(k), phi_dot(k), none, none, constants);
    phi_ddot = force_phi/mm;
    if (! isempty (scene.rotation))
      phi_ddot = scene.rotation (inside(k))(3);
    endif
    loads(:,k) = (P.'*[force_V - m*phi_ddot; force_phi - mm*phi_ddot])./mass;
  endfor
  start = initial_coordinates (scene.initial, model, prescribed);
  eta = oscillations (omega, scene.rod.damping*omega.^2, times, loads, [start(1:n,1); start(1:n,2)]);
  [along, across] = functions_at (model.base, linspace (0, model.length, 41).');
  lever = linspace (0, model.length, 41).'*phi_of_q.';
  size_of = max (abs ([along*model.basis; across*model.basis + lever]), [], 1).';
  response.omega = omega;
  response.largest = size_of.*max (abs (eta), [], 2);
  response.beyond_static = size_of.*max (abs (eta - loads./omega.^2), [], 2);
endfunction

## 400 equal steps from break to break, and the same times just inside of the breaks
function [times, inside] = fine_times (scene)
  [~, ends] = meet_breaks ([0, scene.duration], scene.breaks);
  times = inside = [];
  for k = 1:numel (ends) - 1
    times = [times, linspace(ends(k), ends(k+1), 401)];
    bounds = inside_of (ends([k, k+1]));
    inside = [inside, linspace(bounds(1), bounds(2), 401)];
  endfor
endfunction

function [phi, phi_dot] = rigid_motion (scene, model, times)
  system = rod_system (scene, model);
  [asked, ~, back] = unique (times);
  states = integrate (system, asked, struct ("name", "auto", "tolerance", 1e-3*scene.rod.length));
  motion = system.motion (times, states(:,back));
  phi = motion.phi;
  phi_dot = motion.phi_dot;
endfunction

## eta_ddot + damping eta_dot + omega^2 eta = load, which is linear in time between the times
function eta = oscillations (omega, damping, times, loads, z)
  n = numel (omega);
  eta = zeros (n, numel (times));
  eta(:,1) = z(1:n);
  step = struct ("h", 0);
  for k = 2:numel (times)
    h = times(k) - times(k-1);
    if (h > 0 && abs (h - step.h) > 1e-9*h)
      step = exponential_step (omega, damping, h, 0);
    endif
    if (h == 0)
      eta(:,k) = z(1:n);
      continue;
    endif
    from = [zeros(n, 1); loads(:,k-1)];
    change = [zeros(n, 1); loads(:,k) - loads(:,k-1)];
    f = step.whole;
    z = f.free(:,1).*z + f.free(:,2).*z(step.swap) + f.phi1(:,1).*from + f.phi1(:,2).*from(step.swap) ...
        + f.phi2(:,1).*change + f.phi2(:,2).*change(step.swap);
    eta(:,k) = z(1:n);
  endfor
endfunction

%!function response = of_moment (moment, damping = 0)   # of two modes in 20 ms, without weight
%!  scene = setfield (setfield (paper (), "moment", moment), "gravity", 0);
%!  [scene.moment_breaks, scene.duration, scene.rod.damping] = deal ([], 0.02, damping);
%!  scene = check_scene (scene);
%!  rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%!  response = linear_response (scene, build_model (scene, setfield (rigid, "bending", 2)), build_model (scene, rigid));
%!endfunction
%!test # a step of the moment: each mode swings to twice its static value, or as far as its damping lets it
%! response = of_moment (1e-3);
%! assert (response.largest./response.beyond_static, [2; 2], 0.01);
%! damped = of_moment (1e-3, 2*0.2/response.omega(1));
%! zeta = 0.2*damped.omega/response.omega(1);
%! assert (damped.largest(1)/damped.beyond_static(1), 1 + exp (-pi*zeta(1)/sqrt (1 - zeta(1)^2)), 0.005);
%!test # a moment that grows: each mode swings about its static value by the load's rate over its frequency
%! response = of_moment (@(t) 1e-3*t/0.02);
%! assert (response.beyond_static.*response.omega*0.02, of_moment (1e-3).beyond_static, -0.01);
%!test # a moment that doubles after half a period of the first mode: that rests then, which the jump does not hide
%! step = of_moment (1e-3);
%! half = pi/step.omega(1);
%! doubled = of_moment (@(t) 1e-3*(1 + (t > half)));
%! assert (doubled.beyond_static(1), step.beyond_static(1), -0.01); assert (doubled.largest(1), step.largest(1), -0.01);
