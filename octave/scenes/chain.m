## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} chain (@var{n})
## A chain of @var{n} rods of 0.1 m (5, or what SCENE="chain(20)" says), hinged to each other and to the ground, let
## go from the horizontal.
## @end deftypefn

function scene = chain (n = 5)
  rod = struct ("length", 0.1, "width", 0.01, "half_height", 0.001, "density", 7800);
  scene.title = sprintf ("A chain of %d rods", n);
  body = struct ("rod", rod, "model", struct ("modes", [0 1], "energy", "uniaxial"));
  scene.bodies(1:n) = {body};
  scene.joints{1} = struct ("kind", "revolute", "bodies", 1, "stations", 0);
  for k = 2:n
    scene.joints{k} = struct ("kind", "revolute", "bodies", [k, k-1], "stations", [0 0.1]);
  endfor
  scene.duration = 1;
  scene.solver.tolerance = 1e-6;
endfunction

%!test # n rods, one behind the other: the last one's tip is n lengths away
%! [start, warnings, system] = assembled (chain (7), 0);
%! assert (warnings, {});
%! assert (measure_mechanism (system, 0, start).bodies(7).tip_x, 0.7, 1e-12);
