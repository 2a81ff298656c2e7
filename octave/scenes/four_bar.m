## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} four_bar ()
## A four-bar linkage with an elastic coupler: a short crank turns through, a longer rocker swings; the crank is
## brought to two turns a second and its drive is then smooth.
## @end deftypefn

function scene = four_bar ()
  scene.title = "Four-bar linkage with an elastic coupler";
  [crank, coupler, rocker, ground] = deal (0.2, 0.7, 0.5, 0.6);
  steel = @(length, half_height) struct ("length", length, "width", 0.02, "half_height", half_height);
  angle = acos ((coupler^2 + (ground - crank)^2 - rocker^2)/(2*coupler*(ground - crank)));
  tip = [crank + coupler*cos(angle), coupler*sin(angle)];
  stiff = struct ("modes", [0 0]);
  scene.bodies = {
    struct("name", "crank", "rod", steel (crank, 0.01), "model", stiff)
    struct("name", "coupler", "rod", steel (coupler, 0.003), ...
           "model", struct ("modes", "auto", "energy", "uniaxial"), "initial", struct ("phi", angle))
    struct("name", "rocker", "rod", steel (rocker, 0.01), "model", stiff, ...
           "initial", struct ("phi", atan2 (tip(2), tip(1) - ground)))
  };
  drive = @(t) 4*pi*[min(t, 0.5)^2 + max(t - 0.5, 0), min(2*t, 1), 2*(t < 0.5)];
  scene.joints = {
    struct("name", "crankshaft", "kind", "revolute", "bodies", 1, "stations", 0)
    struct("name", "motor", "kind", "angle", "bodies", 1, "stations", 0, "value", drive)
    struct("name", "crank pin", "kind", "revolute", "bodies", [1 2], "stations", [crank 0])
    struct("name", "rocker pin", "kind", "revolute", "bodies", [2 3], "stations", [coupler rocker])
    struct("name", "rocker bearing", "kind", "revolute", "bodies", 3, "stations", 0, "point", [ground 0])
  };
  scene.breaks = 0.5;
  scene.duration = 1.4;
  scene.zoom = 100;
endfunction

%!test # it can be assembled
%! assembled (four_bar (), 1);
