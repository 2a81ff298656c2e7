## -*- texinfo -*-
## @deftypefn {} {@var{patch} =} surface_patch (@var{system}, @var{scene}, @var{history})
## What is drawn of the surface: a grid of the chart around all that the rod reaches, as a struct of the 36-by-36
## matrices @code{x}, @code{y}, @code{z} (m) and @code{shade} (0 to 1).
## @end deftypefn

function patch = surface_patch (system, scene, history)
  lines = 36;
  for i = 1:2
    low = min (history.alpha{i}(:));
    high = max (history.alpha{i}(:));
    margin{i} = [low, high];
  endfor
  place = struct ("alpha1", history.alpha{1}(:,1), "alpha2", history.alpha{2}(:,1));
  [a_11, ~, a_22] = system.surface.mass (place, struct ("rhoA", 1));
  lengths = sqrt ([max(a_11), max(a_22)]);
  spans = [diff(margin{1}), diff(margin{2})].*lengths;
  for i = 1:2
    wider = (0.15*max (spans) + 0.3*max (0, 0.5*max (spans) - spans(i)))/lengths(i);
    grid{i} = linspace (margin{i}(1) - wider, margin{i}(2) + wider, lines);
  endfor
  [place.alpha1, place.alpha2] = meshgrid (grid{:});
  [x, y, z] = system.surface.position (place);
  [n_1, n_2, n_3] = system.surface.normal (place);
  azimuth = deg2rad (scene.view.azimuth + 30);
  shade = 0.55 + 0.45*abs (0.55*(n_1*sin(azimuth) - n_2*cos(azimuth)) + 0.8*n_3);
  patch = struct ("x", x, "y", y, "z", z, "shade", shade);
endfunction

%!test # all of the rod lies within
%! scene = check_surface_scene (setfield (bowl (), "duration", 0.02));
%! scene.model.modes = [4 4];
%! system = surface_rod (scene);
%! history = measure_surface (system, scene, 0, system.initial_state);
%! patch = surface_patch (system, scene, history);
%! assert (size (patch.shade), [36 36]);
%! assert (min (patch.x(:)) < min (history.x) && max (patch.z(:)) > max (history.z));
%!test # 0.15 of the larger span beyond the rod's, across it 0.3 of half that span more; lit from the camera's right
%! scene.view.azimuth = 60;
%! system.surface = surface_functions (struct ("name", "plane", "inclination", 0));
%! patch = surface_patch (system, scene, struct ("alpha", {{[0; 2], [1; 1]}}));
%! assert ([min(patch.x(:)), max(patch.x(:)), min(patch.y(:)), max(patch.y(:))], [-0.3 2.3 0.4 1.6], 1e-12);
%! assert (patch.z, zeros (36), 1e-12); assert (patch.shade, (0.55 + 0.45*0.8)*ones (36), 1e-12);
%! system.surface = surface_functions (struct ("name", "plane", "inclination", pi/2));
%! scene.view.azimuth = 0;
%! shade = surface_patch (system, scene, struct ("alpha", {{[0; 2], [1; 1]}})).shade;
%! scene.view.azimuth = 60;
%! turned = surface_patch (system, scene, struct ("alpha", {{[0; 2], [1; 1]}})).shade;
%! assert (sort ([shade(1), turned(1)]), 0.55 + 0.45*0.55*[0, sqrt(3)/2], 1e-12);
