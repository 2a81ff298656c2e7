## -*- texinfo -*-
## @deftypefn {} {} film_mode (@var{output}, @var{scene}, @var{found}, @var{mode}, @var{title})
## The vibration number @var{mode} about the equilibrium that was @var{found} (see @code{at_rest}) of a @var{scene},
## one period slowed down to two seconds: mode_N.mp4 and mode_N.gif in the folder of @var{output} (see
## @code{take_options}). A film that cannot be made is a warning.
## @end deftypefn

function film_mode (output, scene, found, mode, title)
  name = sprintf ("mode_%d", mode);
  files = strcat (name, {".mp4", ".gif"});
  step = found.linear.basis*found.vibrations.shape(:,mode);
  [rest, ~, ahead] = pushed_lines (found.balance, found.q, step);
  missing = cell (0, 2);
  publish_run (output.folder, files, @film);
  cellfun (@(text) say ("warning: %s", text), missing_warnings (missing));
  say ("%s/ has %s", output.folder, strjoin (setdiff (files, missing(:,1), "stable"), ", "));

  function film (aside)
    drawing = swaying (scene, rest, ahead, title);
    frames = numel (drawing.time);
    missing = draw_files (aside, {@(scratch) draw_frames(drawing, scratch)}, frame_names (1:frames, frames));
    if (isempty (missing))
      missing = make_film (frames, drawing.frames_per_second, aside);
    endif
    missing(:,1) = strrep (missing(:,1), "animation", name);
    for file = setdiff (files, missing(:,1))
      rename (fullfile (aside, strrep (file{1}, name, "animation")), fullfile (aside, file{1}));
    endfor
  endfunction
endfunction

## what @code{draw_pictures} takes: lines to both sides of where they rest
function drawing = swaying (scene, rest, ahead, title)
  t = (0:59)/30;
  none = zeros (0, numel (t));
  drawing = struct ("title", [scene.title ": " title], "time", t, "frames_per_second", 30, "zoom", 1, "gravity", 0, ...
                    "frame_size", scene.frame_size, "moment", 0*t, "moment_breaks", [], "strips", [], ...
                    "hinges", struct ("x", none, "y", none));
  for k = 1:numel (rest)
    still = on_picture (rest{k}, scene);
    way = on_picture (ahead{k}, scene) - still;
    x = still(:,1) + way(:,1)*sin (pi*t);
    y = still(:,2) + way(:,2)*sin (pi*t);
    body = struct ("half_height", 0, "x", x, "y", y, "rest_x", repmat (still(:,1), 1, numel (t)), ...
                   "rest_y", repmat (still(:,2), 1, numel (t)), "stress", []);
    drawing.bodies(k) = body;
  endfor
endfunction

%!function check_film (folder)
%!  scene = setfield (chain (1), "frame_size", [320 320]);
%!  evalc ("natural_modes (scene, 'output', folder, 'film', [1 9]);");   # a rigid pendulum has no ninth
%!  assert (sort (readdir (folder)(3:end)), {"mode_1.gif"; "mode_1.mp4"; "modes.csv"; "modes.png"; "modes.svg"});
%!  assert (stat (fullfile (folder, "mode_1.gif")).size > 5000);
%!endfunction
%!test
%! [folder, gone] = scratch_folder ();
%! check_film (folder);
%!error <film is 0: it takes numbers of modes, from 1 to 12> natural_modes ("swing", "film", 0);
