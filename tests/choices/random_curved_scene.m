## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_curved_scene (@var{seed})
## A scene of a curved hinged rod drawn at random: an arc, a hook (straight, then an arc) or a spiral (the curvature
## grows along it) that turns by 0.3 to 4 rad, under a pulse of the moment, its weight, or both.  Loads are scaled to
## the rod, so that slopes stay small.
## @end deftypefn

function scene = random_curved_scene (seed)
  scene = with_seed (2000 + seed, @drawn_scene);
  scene.title = sprintf ("Random curved scene %d", seed);
endfunction

function scene = drawn_scene ()
  l = random_between (0.3, 3);
  h = l/random_between (20, 200);
  E = random_between (2e9, 2e11);
  rhoA = random_between (1000, 9000)*h^2;
  EI = E*h^4/12;
  turn = random_between (0.3, 4)*sign (rand () - 0.5);
  rod = struct ("length", l, "EA", E*h^2, "EI", EI, "rhoA", rhoA, "half_height", h/2);
  rod.damping = (rand () < 0.3)*1e-5;
  switch (ceil (3*rand ()))
    case 1
      curvature = turn/l;
    case 2
      straight = l*random_between (0.2, 0.7);
      curvature = @(xi) turn/(l - straight)*(xi > straight);
      rod.curvature_breaks = straight;
    case 3
      curvature = @(xi) 2*turn*xi/l^2;
  endswitch
  scene.rod = setfield (rod, "curvature", curvature);
  scene.model.energy = "uniaxial";
  period = 2*pi/15.42*l^2*sqrt (rhoA/EI);
  scene.gravity = min (9.81, random_between (0.001, 0.1)*EI/(rhoA*l^3));
  moment = random_between (1e-3, 0.03)*EI/l;
  ending = period*random_between (0.2, 3);
  scene.moment = @(t) moment*sin (pi*t/ending).^2.*(t < ending);
  scene.moment_breaks = ending;
  scene.initial.phi = pi*(2*rand () - 1);
  scene.duration = period*random_between (1, 5);
  scene.frames_per_second = 40/scene.duration;
  scene.solver.tolerance = l*random_between (1e-5, 1e-4);
endfunction

%!test # the same seed gives the same scene; all are scenes of the rod, and all three shapes are drawn
%! assert (random_curved_scene (1).rod.length, random_curved_scene (1).rod.length);
%! shapes = zeros (1, 3);
%! for seed = 1:30
%!   scene = random_curved_scene (seed);
%!   assert (kind_of (scene).name, "curved rod");
%!   check_scene (scene);
%!   shapes(1 + is_function_handle (scene.rod.curvature) + isfield (scene.rod, "curvature_breaks"))++;
%!   l = scene.rod.length;
%!   turns(seed) = scene.rod.curvature(1)*l;
%!   if (is_function_handle (scene.rod.curvature))
%!     turns(seed) = quadgk (scene.rod.curvature, 0, l, "waypoints", [0.2:0.01:0.7]*l);
%!   endif
%! endfor
%! assert (shapes, [10 10 10], 6);
%! assert (abs (turns) >= 0.299 & abs (turns) <= 4.01); assert (mean (turns > 0), 0.5, 0.25);
