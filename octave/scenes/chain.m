## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} chain (@var{n})
## A chain of @var{n} rods of 0.1 m (5, or what SCENE="chain(20)" says), hinged to each other and to the ground, let
## go from the horizontal.
## @end deftypefn

function scene = chain (n = 5)
  rod = struct ("length", 0.1, "width", 0.01, "half_height", 0.001, "density", 7800);
  scene.title = sprintf ("A chain of %d rods", n);
  body = struct ("rod", rod, "model", struct ("modes", [0 1], "energy", "uniaxial"));
  for k = 1:n
    scene.bodies{k} = body;
    joint = struct ("kind", "revolute", "bodies", [k, k-1], "stations", [0 0.1](1:1+(k > 1)));
    scene.joints{k} = joint;
  endfor
  scene.duration = 1;
  scene.solver.tolerance = 1e-6;
endfunction

%!assert (numel (chain (7).joints), 7)
