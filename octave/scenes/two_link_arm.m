## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} two_link_arm ()
## An elastic arm of two links whose joints' motion is prescribed: both turn from rest to rest in 0.8 s, by a
## polynomial of degree 5, with a load of 0.5 kg at the tip; the arm then rings.
## @end deftypefn

function scene = two_link_arm ()
  scene.title = "A two-link arm brings a load to rest";
  link = struct ("length", 0.6, "width", 0.03, "half_height", 0.003, ...
                 "lambda", 6e10, "mu", 2.6e10, "density", 2700, "damping", 1e-4);
  model = struct ("modes", "auto", "energy", "uniaxial");
  turn = @(t, from, by) [from, 0, 0] + by*smooth_step (min (t/0.8, 1)).*0.8.^-(0:2);
  scene.bodies = {
    struct("name", "upper arm", "rod", link, "model", model, "tip_mass", 0)
    struct("name", "forearm", "rod", link, "model", model, "tip_mass", 0.5, "initial", struct ("phi", pi/2))
  };
  scene.joints = {
    struct("name", "shoulder", "kind", "revolute", "bodies", 1, "stations", 0)
    struct("name", "shoulder's motor", "kind", "angle", "bodies", 1, "stations", 0, "value", @(t) turn (t, 0, pi/2))
    struct("name", "elbow", "kind", "revolute", "bodies", [2 1], "stations", [0 0.6])
    struct("name", "elbow's motor", "kind", "angle", "bodies", [2 1], "stations", [0 0.6], ...
           "value", @(t) turn (t, pi/2, -pi/2))
  };
  scene.breaks = 0.8;
  scene.duration = 1.5;
  scene.zoom = 5;
  scene.solver.tolerance = 1e-5;
endfunction

## 0 to 1, with the first two rates
function row = smooth_step (s)
  row = [s^3*(10 - 15*s + 6*s^2), 30*s^2*(1 - s)^2, 60*s*(1 - s)*(1 - 2*s)];
endfunction

%!test # it can be assembled
%! assembled (two_link_arm (), 1);
