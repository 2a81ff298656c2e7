## -*- texinfo -*-
## @deftypefn {} {@var{psi} =} tangent_at (@var{model}, @var{station}, @var{phi}, @var{V})
## The angle (1-by-m, rad) of the tangent at the @var{station} (m) of a rod in the fixed frame (27): @var{phi} (1-by-m)
## and the amplitudes @var{V} of all base functions (N-by-m, m) turn it from its direction in the undeformed rod.
## @end deftypefn

function psi = tangent_at (model, station, phi, V)
  [slopes.slope_1, slopes.slope_2] = slopes_at (model.base, station, model.shortening);
  [~, ~, undeformed] = undeformed_places (model.base, station);
  psi = rod_tangent_angle (struct ("phi", phi, "V", V), slopes) + undeformed;
endfunction

%!test # half a wave: as steep at both ends, and a stretch that makes the slope less
%! model = struct ("base", base_functions (1, 1, 2), "shortening", 0);
%! V = [0.1 0.1; 0.2 0];
%! assert (tangent_at (model, 0, [1 2], V), [1 + atan(0.1*pi/(1 + 0.1*pi/4)), 2], 1e-14);
%! assert (tangent_at (model, 2, [1 2], V), [1 - atan(0.1*pi), 2], 1e-14);
%! model.shortening = 1;
%! assert (tangent_at (model, 0, [1 2], V), [1 + atan(0.1*pi), 2], 1e-14);
%!test # a semicircle's ends lie half a turn apart
%! scene.rod = struct ("length", 1, "curvature", pi, "EA", 1e6, "EI", 10, "rhoA", 1); scene.duration = 1;
%! scene = check_scene (scene);
%! model = build_curved_model (scene, rung_of_scene (setfield (scene, "model", "modes", [1 1])));
%! V = zeros (numel (model.arrays.coupling_vector), 1);
%! assert (tangent_at (model, 1, 0.3, V) - tangent_at (model, 0, 0.3, V), pi, 1e-12);
