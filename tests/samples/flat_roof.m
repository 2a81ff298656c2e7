## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{factor}, @var{height}] =} flat_roof ()
## The checked @var{scene} of two hinged bars of 1 m as a roof of this @var{height} (m; von Mises 1923) under the
## largest force that its apex bears, and the @var{factor} (y) of it that keeps the apex at y (m).
## @end deftypefn

function [scene, factor, height] = flat_roof ()
  bar = struct ("rod", struct ("length", 1, "EA", 1e3, "EI", 1e6, "rhoA", 1, "half_height", 0.01), "model", ...
                struct ("modes", "auto", "energy", "uniaxial", "rotary_inertia", false));
  half = cos (0.2);
  height = sin (0.2);
  force = @(y) 2e3*y.*(1./hypot (half, y) - 1);
  largest = force (sqrt (half^(4/3) - half^2));
  factor = @(y) force (y)/largest;
  scene.bodies = {setfield(bar, "initial", struct ("phi", 0.2)), ...
                  setfield(bar, "initial", struct ("phi", pi - 0.2, "x", 2*half, "y", 0))};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
                  struct("kind", "revolute", "bodies", 2, "stations", 0, "point", [2*half 0]), ...
                  struct("kind", "revolute", "bodies", [1 2], "stations", [1 1]), ...
                  struct("kind", "slider", "bodies", 1, "stations", 1, "point", [half 0], "direction", pi/2), ...
                  struct("kind", "force", "bodies", 1, "stations", 1, "value", [0 -largest])};
  [scene.gravity, scene.duration] = deal (0, 1);
  scene = check_mechanism (scene);
endfunction

%!test # it bears nothing where its bars are as long as they are made, and the most where L^3 = a^2 l
%! [~, factor, height] = flat_roof ();
%! assert (factor ([height 0 -height]), [0 0 0], 1e-12);
%! assert (factor (sqrt (cos (0.2)^(4/3) - cos (0.2)^2) + [-1e-3 0 1e-3]) <= 1);
