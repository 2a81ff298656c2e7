## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_path (@var{found}, @var{scene}, @var{scratch})
## What @code{load_path} has @var{found}, as path.svg and path.png beside the folder @var{scratch}, which takes the
## data: the factor against the place that moves most, dashed where unstable, with its events, and shapes of the rods
## along the path, from faint to dark, with the modes of the events.  They are there when @var{job} has ended (see
## @code{finish_tool}).
## @end deftypefn

function job = draw_path (found, scene, scratch)
  [names, places] = path_places (found.shape);
  [~, most] = max (range (places, 2));
  along = [places(most,:); found.factor].';
  is_event = found.event > 0;
  [shapes, modes] = drawn_lines (found, scene);
  every = vertcat (shapes{:}, modes{:});
  room = 0.05*max (range (every));
  settings = struct ("title", scene.title, "place", [names{most} ", m"], "names", {{found.events.what}}, ...
                     "shapes", numel (shapes), "modes", numel (modes), ...
                     "x", [min(every(:,1)) - room, max(every(:,1)) + room], ...
                     "y", [min(every(:,2)) - room, max(every(:,2)) + room]);
  text = [gnuplot_settings(settings), gnuplot_block("stable", {lifted(along, found.stable | is_event)}), ...
          gnuplot_block("unstable", {lifted(along, ! found.stable | is_event)}), ...
          gnuplot_block("events", {[along(is_event,:); NaN NaN]})];
  for k = 1:numel (shapes)
    text = [text, gnuplot_block(sprintf ("shape_%d", k), shapes(k))];
  endfor
  for k = 1:numel (modes)
    text = [text, gnuplot_block(sprintf ("mode_%d", k), modes(k))];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "path.gp");
endfunction

function rows_of = lifted (rows_of, drawn)
  rows_of(! drawn,:) = NaN;
endfunction

## of eight points spread over the path, and of the events, all bodies at a time
function [shapes, modes] = drawn_lines (found, scene)
  points = evenly_chosen (numel (found.factor), 8);
  shapes = arrayfun (@(k) one_line (cellfun (@(places) places(:,:,k), found.shape, "uniformoutput", false), scene), ...
                     points, "uniformoutput", false);
  modes = cellfun (@(lines) one_line (lines, scene), {found.events.mode}, "uniformoutput", false);
endfunction

function line = one_line (lines, scene)
  lines = cellfun (@(places) [on_picture(places, scene); NaN NaN], lines, "uniformoutput", false);
  line = vertcat (lines{:});
endfunction

%!function check (found, scene)
%!  [folder, gone] = scratch_folder ();
%!  draw = {@(scratch) draw_path(found, scene, scratch)};
%!  assert (draw_files (folder, draw, {"path.svg", "path.png"}), cell (0, 2));
%!endfunction
%!test # on a plane with an event, in space without one
%! scene = struct ("title", "it's a \"rod\"", "view", struct ("elevation", 20, "azimuth", 30));
%! found = struct ("factor", [0 0.5 1], "stable", [true true false], "event", [0 1 0], "shape", ...
%!                 {{rand(5, 2, 3), rand(5, 2, 3)}}, "events", ...
%!                 struct ("what", "limit point", "mode", {{rand(5, 2), rand(5, 2)}}));
%! check (found, scene);
%! found = setfield (setfield (found, "shape", {rand(5, 3, 3)}), "event", [0 0 0]);
%! check (setfield (found, "events", struct ("what", {}, "mode", {})), scene);
