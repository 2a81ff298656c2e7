## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} ring ()
## A ring of steel, cut at the point that it hangs from: it falls from the side, and its ends open.
## @end deftypefn

function scene = ring ()
  scene.title = "A cut ring falls about its hinge";
  scene.rod = struct ("length", 2*pi*0.2, "width", 0.02, "half_height", 0.003, "curvature", -5);
  scene.model.energy = "uniaxial";
  scene.initial.phi = 0;
  scene.duration = 1.2;
  scene.zoom = 15;
  scene.solver.tolerance = 1e-3;
endfunction

%!test # it closes
%! rod = check_scene (ring ()).rod;
%! [x, y] = undeformed_places (struct ("axis", rod_axis (rod, 16)), rod.length);
%! assert (hypot (x, y), 0, 1e-9);
