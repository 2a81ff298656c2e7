## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} draw_surface_pictures (@var{system}, @var{scene}, @var{history}, @var{folder})
## Frames, film and figures of a rod on a surface (see @code{measure_surface}), written into the existing @var{folder}, with
## the files' names of @code{draw_pictures}: the surface in three dimensions, what lies behind it hidden, under a
## camera that stands or turns (scene.view).
## @end deftypefn

function warnings = draw_surface_pictures (system, scene, history, folder)
  scratch = fullfile (folder, "scratch");
  mkdir (scratch);
  mkdir (fullfile (folder, "frames"));
  unwind_protect
    [patch, settings] = surface_drawing (system, scene, history);
    settings.kinds = "png";
    frames = numel (history.t);
    write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), gnuplot_block("surface", {patch})]);
    for k = 1:frames
      write_text (fullfile (scratch, sprintf ("%04d.gp", k)), frame_text (scene, history, k, k, sprintf ("../frames/frame_%04d", k)));
    endfor
    run_gnuplot (scratch, "surface.gp", frames);
    settings.kinds = "svg png pdf";
    write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), gnuplot_block("surface", {patch})]);
    shown = unique (round (linspace (1, frames, 9)));
    write_text (fullfile (scratch, "0001.gp"), frame_text (scene, history, shown, frames, "../figure3"));
    run_gnuplot (scratch, "surface.gp", 1);
    draw_surface_history (scene, history, scratch);
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (scratch, "s");
  end_unwind_protect
  warnings = make_film (scene.frames_per_second, folder);
endfunction

## the rod at the frames shown, the tip's path up to the last one, a little towards the rod's side of the surface
function text = frame_text (scene, history, shown, last, name)
  settings.name = name;
  settings.clock = sprintf ("t = %.*f s", max (2, ceil (log10 (scene.frames_per_second))), history.t(last));
  settings.elevation = 90 - scene.view.elevation;
  settings.azimuth = mod (90 + scene.view.azimuth + scene.view.turning*history.t(last), 360);
  settings.rods = numel (shown);
  lift = scene.rod.half_height*(scene.surface.side + (scene.surface.side == 0));
  place = @(i, k) [history.x(i,k) + lift*history.n_1(i,k), history.y(i,k) + lift*history.n_2(i,k), ...
                   history.z(i,k) + lift*history.n_3(i,k)];
  rods = arrayfun (@(k) place (1:rows (history.x), k), shown, "uniformoutput", false);
  tip = reshape (place (rows (history.x), 1:last), [], 3);
  text = [gnuplot_settings(settings), gnuplot_block("rod", rods), gnuplot_block("tip", {tip([1:end, end],:)})];
endfunction

%!test # frames of the right size
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   scene = check_surface_scene (setfield (bowl (), "duration", 0.02));
%!   system = surface_rod (scene);
%!   y = system.initial_state;
%!   draw_surface_pictures (system, scene, measure_surface (system, scene, [0 0.02], [y y]), folder);
%!   information = imfinfo (fullfile (folder, "frames", "frame_0002.png"));
%!   assert ([information.Width, information.Height], [1280, 720]);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
