## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} surface_drawing (@var{system}, @var{scene}, @var{history})
## What the pictures show of a run of a rod on a surface (see @code{measure_surface}): the struct that
## @code{draw_pictures} takes. Its body is the rod as the camera sees it at the start, its field @code{surface} what is
## drawn in three dimensions (see @code{draw_surface_frames}).
## @end deftypefn

function drawing = surface_drawing (system, scene, history)
  frames = numel (history.t);
  drawing = struct ("title", scene.title, "time", history.t, "frames_per_second", scene.frames_per_second, ...
                    "frame_size", scene.frame_size, "zoom", 1, "gravity", scene.gravity, ...
                    "moment", zeros (1, frames), "moment_breaks", scene.breaks);
  ## A little towards the rod's side of the surface, which would hide it.
  lift = scene.rod.half_height*scene.surface.side;
  if (scene.surface.side == 0)
    lift = scene.rod.half_height;
  endif
  rod = struct ("x", history.x + lift*history.n_1, "y", history.y + lift*history.n_2, ...
                "z", history.z + lift*history.n_3);
  patch = surface_patch (system, scene, history);
  drawing.surface = struct ("held", ! strcmp (scene.ends, "free"), "patch", patch, "rod", rod, ...
                            "room", 3*scene.rod.half_height, "elevation", scene.view.elevation, ...
                            "azimuth", scene.view.azimuth + scene.view.turning*history.t);

  [x, y] = seen (rod, scene.view);
  drawing.bodies = struct ("half_height", scene.rod.half_height, "x", x, "y", y, "rest_x", x, "rest_y", y, ...
                           "stress", []);
  held = [1, rows(x)](! strcmp (scene.ends, "free"));
  drawing.hinges = struct ("x", x(held,:), "y", y(held,:));
  [x, y] = seen (patch, scene.view);
  drawing.backdrop = [lines_of(x, y), lines_of(x.', y.')];

  [springs, forces] = acting_in_space (scene, history);
  drawing.surface.springs = springs;
  drawing.surface.forces = forces;
  [x, y] = seen (springs, scene.view);
  ends = struct ("x", springs.to_x, "y", springs.to_y, "z", springs.to_z);
  [to_x, to_y] = seen (ends, scene.view);
  drawing.springs = struct ("x", x, "y", y, "to_x", to_x, "to_y", to_y, "shape", {repmat({"coil"}, rows (x), 1)});
  [x, y] = seen (forces, scene.view);
  [F_x, F_y] = seen (struct ("x", forces.F_x, "y", forces.F_y, "z", forces.F_z), scene.view);
  drawing.forces = struct ("x", x, "y", y, "F_x", F_x, "F_y", F_y);

  panels = surface_panels (scene, history);
  drawing.strips = panels(ismember ({panels.label}, {"tip", "reaction", "energies"}));
  drawing.equations = {"surface", ["surface_" scene.surface.name]};
endfunction

## each fifth column, x and y
function lines = lines_of (x, y)
  lines = arrayfun (@(k) [x(:,k), y(:,k)], 1:5:columns (x), "uniformoutput", false);
endfunction

%!test # from above, x is to the right for a camera in the direction of -y
%! scene = check_surface_scene (setfield (setfield (bowl (), "duration", 0.02), "view", ...
%!                                        struct ("elevation", 90, "azimuth", -90, "turning", 0)));
%! scene.model.modes = [4 4];
%! system = surface_rod (scene);
%! history = measure_surface (system, scene, [0 1], [system.initial_state, system.initial_state]);
%! drawing = surface_drawing (system, scene, history);
%! check_drawing (setfield (drawing, "panels", surface_panels (scene, history)));
%! for side = [1 0 -1]  # where both sides hold it, as on the first
%!   lifted = surface_drawing (system, setfield (scene, "surface", "side", side), history).surface.rod.z(1);
%!   assert (lifted - history.z(1), scene.rod.half_height*history.n_3(1)*(1 - 2*(side < 0)), 1e-12);
%! endfor
%! assert ([drawing.zoom, drawing.surface.room/scene.rod.half_height, drawing.moment], [1 3 0 0], 1e-12);
%! assert (size (drawing.backdrop), [1 16]); assert (drawing.equations, {"surface", ["surface_" scene.surface.name]});
%! assert (cellfun (@(panel) panel.label, num2cell (drawing.strips), "uniformoutput", false){1}(1:3), "tip");
%! assert (drawing.bodies.x, drawing.surface.rod.x, 1e-12);
%! assert (drawing.bodies.y, drawing.surface.rod.y, 1e-12);
%! assert (columns (drawing.hinges.x), 2); assert (rows (drawing.hinges.x), 0);
%! room = drawing.surface.room;  # for the thickness of the rod, of which the axis is given
%! assert (room > 2*scene.rod.half_height && room < 0.1*scene.rod.length);
