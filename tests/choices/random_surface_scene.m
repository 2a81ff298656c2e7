## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} random_surface_scene (@var{seed})
## A scene of a rod on a surface drawn at random: by turns an upright or inclined plane, a cylinder, a cone, a sphere,
## a torus, a saddle and bumps, whose radii are some lengths of the rod; its ends free or the first one hinged; from
## rest, under its weight, with or without a force at its tip.
## @end deftypefn

function scene = random_surface_scene (seed)
  scene = with_seed (3000 + seed, @() drawn_scene (mod (seed - 1, 7) + 1));
  scene.title = sprintf ("Random surface scene %d", seed);
endfunction

function scene = drawn_scene (k)
  l = random_between (0.3, 2);
  [scene.surface, scene.initial.point] = drawn_surface (k, l);
  rhoA = random_between (0.05, 0.5);
  EI = rhoA*l^4*random_between (20, 200);  # its slowest bending takes some tenths of a second
  scene.rod = struct ("length", l, "EA", EI/l^2*random_between(1e3, 1e5), "EI", EI, "rhoA", rhoA);
  scene.rod.EI_normal = EI*random_between (0.05, 1);
  scene.rod.GJ = (rand () < 0.5)*0.5*EI;
  scene.surface.side = 0;
  scene.initial.angle = pi*(2*rand () - 1);
  if (rand () < 0.4)
    scene.ends = {"hinge", "free"};
  endif
  if (rand () < 0.5)
    size = 0.3*rhoA*l*9.81*(2*rand (1, 3) - 1);
    scene.force = @(t) size.*sin (5*t(:));
  endif
  scene.duration = random_between (0.3, 1)*sqrt (l);
  scene.frames_per_second = 40/scene.duration;
  scene.solver.tolerance = l*random_between (1e-4, 1e-3);
endfunction

function [surface, point] = drawn_surface (k, l)
  size = l*random_between (1, 4);
  point = [0 0];
  switch (k)
    case 1
      surface = struct ("name", "plane", "inclination", random_pick ([pi/2, 0.5]));
    case 2
      surface = struct ("name", "cylinder", "radius", size);
      point = [0, 0.5*size*(2*rand () - 1)];
    case 3
      surface = struct ("name", "cone", "half_angle", random_between (0.3, 1));
      point = [3*size, rand()];
    case 4
      surface = struct ("name", "sphere", "radius", size);
      point = 0.5*size*(2*rand (1, 2) - 1);
    case 5
      surface = struct ("name", "torus", "core_radius", 3*size, "tube_radius", size);
      point = [rand(), 2*rand()-1];
    case 6
      surface = struct ("name", "saddle", "rise", 1/size, "fall", 0.5/size);
    case 7
      surface = struct ("name", "bumps", "height", 0.1*size, "wave_number_1", 1/size, "wave_number_2", 1.3/size);
      point = 0.3*size*(2*rand (1, 2) - 1);
  endswitch
endfunction

%!test # the same seed gives the same scene; every surface, and every end, is drawn
%! assert (random_surface_scene (1).rod, random_surface_scene (1).rod);
%! for seed = 1:14
%!   scene = random_surface_scene (seed);
%!   assert (kind_of (scene).name, "surface");
%!   names{seed} = scene.surface.name;
%!   check_surface_scene (scene);
%! endfor
%! assert (numel (unique (names)), 7);
%! hinged = arrayfun (@(seed) isfield (random_surface_scene (seed), "ends"), 1:60);
%! assert (mean (hinged), 0.4, 0.2);
