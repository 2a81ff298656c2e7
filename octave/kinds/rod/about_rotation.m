## -*- texinfo -*-
## @deftypefn {} {[@var{linear}, @var{q}] =} about_rotation (@var{scene}, @var{model}, @var{speed}, @var{q})
## The equations of a @var{model} of one rod linear about its steady rotation at the @var{speed} (rad/s): a struct of
## M, C, K, basis and mass as @code{linearised} has them, of the coordinates of its system, and its coordinates @var{q}
## (n-by-1) then, found near those given ([]: undeformed).  @var{scene} is a checked scene without weight and loads; a
## hub's rotation is replaced.
## @end deftypefn

function [linear, q] = about_rotation (scene, model, speed, q)
  if (! isempty (scene.rotation))
    scene.rotation = @(t) [speed*t; speed + 0*t; 0*t];
  endif
  system = rod_system (scene, model);
  n = rows (system.mass);
  v = zeros (n, 1);
  if (isempty (scene.rotation))
    v(n) = speed;
  endif
  if (isempty (q))
    q = system.initial_state(1:n);
  endif
  rate = system.accelerations.rate;
  steps = 1e-4*system.state_scale(1:n);
  accelerations = @(q, v) rate (zeros (1, columns (q)), [q; v; zeros(2, columns (q))])(n+1:2*n,:);
  held = 1:n - isempty (scene.rotation);  # a hinged rod's angle is free
  for sweep = 1:20
    by_q = difference_quotients (@(x) accelerations (q + x, v + 0*x), steps);
    step = zeros (n, 1);
    step(held) = -by_q(held,held) \ accelerations (q, v)(held,1);
    q += step;
    if (abs (step)./system.state_scale(1:n) < 1e-12*model.length)
      break;
    endif
  endfor
  linear.M = linear.mass = system.mass;
  linear.basis = eye (n);
  linear.K = -system.mass*difference_quotients (@(x) accelerations (q + x, v + 0*x), steps);
  linear.C = -system.mass*difference_quotients (@(x) accelerations (q + 0*x, v + x), steps);
endfunction

%!test # a rod that stretches as it turns: its tip moves by rhoA speed^2 l^3/(3 EA)
%! scene.rod = struct ("length", 2, "EA", 1e5, "EI", 1, "rhoA", 3, "rhoI", 0);
%! [scene.gravity, scene.duration, scene.rotation] = deal (0, 1, @(t) [0*t; 0*t; 0*t]);
%! scene.model = struct ("modes", [25 0], "energy", "uniaxial");
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! [linear, q] = about_rotation (scene, model, 2, []);
%! tip = functions_at (model.base, 2)*(model.basis*q)(1:25);
%! assert (tip, 3*2^2*2^3/(3*1e5), -1e-3);
%! assert (linear.basis, eye (rows (q)));
