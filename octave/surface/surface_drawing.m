## -*- texinfo -*-
## @deftypefn {} {[@var{patch}, @var{settings}] =} surface_drawing (@var{system}, @var{scene}, @var{history})
## What is drawn of the surface: rows x, y, z, shade of a grid of the chart around all that the rod reaches, with a row of
## NaN after each line, and the settings of surface.gp.
## @end deftypefn

function [patch, settings] = surface_drawing (system, scene, history)
  lines = 36;
  for i = 1:2
    low = min (history.alpha{i}(:));
    high = max (history.alpha{i}(:));
    margin{i} = [low, high];
  endfor
  [a_11, ~, a_22] = system.surface.mass (history.alpha{1}(:,1), history.alpha{2}(:,1), 1);
  lengths = sqrt ([max(a_11), max(a_22)]);
  spans = [diff(margin{1}), diff(margin{2})].*lengths;
  for i = 1:2
    wider = (0.15*max (spans) + 0.3*max (0, 0.5*max (spans) - spans(i)))/lengths(i);
    grid{i} = linspace (margin{i}(1) - wider, margin{i}(2) + wider, lines);
  endfor
  [alpha1, alpha2] = meshgrid (grid{:});
  [x, y, z] = system.surface.position (alpha1, alpha2);
  [n_1, n_2, n_3] = system.surface.normal (alpha1, alpha2);
  azimuth = deg2rad (scene.view.azimuth + 30);
  shade = 0.55 + 0.45*abs (0.55*(n_1*sin(azimuth) - n_2*cos(azimuth)) + 0.8*n_3);
  patch = [];
  for k = 1:lines
    patch = [patch; x(:,k), y(:,k), z(:,k), shade(:,k); NaN(1, 4)];
  endfor
  settings = struct ("title", scene.title, "title_size", min (20, 1300/numel (scene.title)), "magnification", 1.5);
  settings.x = around (x, 3*scene.rod.half_height);
  settings.y = around (y, 3*scene.rod.half_height);
  settings.z = around (z, 3*scene.rod.half_height);
endfunction

## with room for the rod, which is drawn over the surface
function range = around (values, room)
  range = [min(values(:)), max(values(:))] + [-1, 1]*room;
endfunction

%!test # a grid with gaps between its lines
%! scene = check_surface_scene (setfield (bowl (), "duration", 0.02));
%! system = surface_rod (scene);
%! y = system.initial_state;
%! [patch, settings] = surface_drawing (system, scene, measure_surface (system, scene, 0, y));
%! assert (columns (patch), 4);
%! assert (all (isnan (patch(37:37:end,1))));
%! assert (settings.z(1) < -0.4 && settings.z(2) > settings.z(1));
