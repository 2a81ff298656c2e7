## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} roof ()
## A flat roof of two elastic rods on hinges, under a force at its apex: 1.4 times as much makes it snap through
## (`make statics SCENE=roof FACTOR=0:0.05:2').
## @end deftypefn

function scene = roof ()
  scene.title = "A flat roof of two rods snaps through";
  slope = 0.1;
  half = cos (slope);
  rod = struct ("length", 1, "width", 0.01, "half_height", 0.05, "lambda", 4e8, "mu", 2e8, "density", 1000);
  material = struct ("rod", rod, "model", struct ("modes", "auto", "energy", "uniaxial"));
  scene.bodies = {setfield(material, "initial", struct ("phi", slope))
                  setfield(material, "initial", struct ("phi", pi - slope, "x", 2*half, "y", 0))};
  scene.joints = {struct("name", "left", "kind", "revolute", "bodies", 1, "stations", 0)
                  struct("name", "right", "kind", "revolute", "bodies", 2, "stations", 0, "point", [2*half 0])
                  struct("name", "apex", "kind", "revolute", "bodies", [1 2], "stations", [1 1])
                  struct("name", "force", "kind", "force", "bodies", 1, "stations", 1, "value", [0 -140])};
  scene.duration = 0.2;
endfunction

%!test # it bears its own weight and this force, and springs back
%! result = driver ("roof", "output", "", "modes", [1 0]);
%! assert (result.history.bodies(1).tip_y > 0.04);
