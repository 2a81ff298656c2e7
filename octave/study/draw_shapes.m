## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_shapes (@var{name}, @var{panels}, @var{scene}, @var{scratch})
## Shapes of rods, a panel each, as @var{name}.svg and .png beside the folder @var{scratch}, which takes the
## data.  They are there when @var{job} has ended (see @code{finish_tool}).  @var{panels} is a struct array of title,
## and of faint and strong lines: cell arrays of [x y], or [x y z] as the scene's camera sees them at the start (m),
## all in one scale.
## @end deftypefn

function job = draw_shapes (name, panels, scene, scratch)
  for k = 1:numel (panels)
    for lines = {"faint", "strong"}
      panels(k).(lines{1}) = cellfun (@(places) rounded (on_picture (places, scene)), panels(k).(lines{1}), ...
                                      "uniformoutput", false);
    endfor
  endfor
  every = vertcat ([panels.faint]{:}, [panels.strong]{:});
  low = min (every);
  high = max (every);
  room = 0.08*max ([high - low, realmin]);
  across = min (3, numel (panels));
  settings = struct ("name", name, "title", scene.title, "titles", {{panels.title}}, ...
                     "across", across, "down", ceil (numel (panels)/across), ...
                     "x", [low(1) - room, high(1) + room], "y", [low(2) - room, high(2) + room]);
  text = gnuplot_settings (settings);
  for k = 1:numel (panels)
    text = [text, gnuplot_block(sprintf ("faint_%d", k), panels(k).faint), ...
            gnuplot_block(sprintf ("strong_%d", k), panels(k).strong)];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "shapes.gp");
endfunction

## a rod bends without corners between the places that it is known at
function line = rounded (places)
  line = places;
  n = rows (places);
  if (n > 3)
    line = interp1 (1:n, places, linspace (1, n, 8*(n - 1) + 1), "spline");
  endif
endfunction

%!test # on a plane and in space
%! scene = struct ("title", "A \"rod\"", "view", struct ("elevation", 20, "azimuth", 30));
%! line = @(n) {rand(5, n), rand(5, n)};
%! for n = [2 3]
%!   [folder, gone] = scratch_folder ();
%!   panels = struct ("title", {"1: 2 Hz", "it's {2}"}, "faint", {line(n), line(n)}, "strong", {line(n), line(n)});
%!   draw = {@(scratch) draw_shapes("modes", panels, scene, scratch)};
%!   assert (draw_files (folder, draw, {"modes.svg", "modes.png"}), cell (0, 2));
%! endfor
%!function text = settings_of (panels, scratch)
%!  finish_tool (draw_shapes ("modes", panels, struct ("title", "A rod"), scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # all shapes fit, with room of 8 % of the larger extent
%! panels = struct ("title", "1", "faint", {{[-1 5; 3 6]}}, "strong", {{[0 4; 2 9]}});
%! text = in_scratch (@(folder, scratch) settings_of (panels, scratch));
%! assert (! isempty (strfind (text, "x_low = -1.4\nx_high = 3.4\ny_low = 3.6\ny_high = 9.4\n")), text);
%!test # a ring of 41 places is round
%! ring = [cos((0:40).'*pi/20), sin((0:40).'*pi/20)];
%! panels = struct ("title", "1", "faint", {{[0 0; 0 0]}}, "strong", {{ring}});
%! text = in_scratch (@(folder, scratch) settings_of (panels, scratch));
%! line = textscan (regexp (text, 'strong_1 << END\n(.*?)END', "tokens", "once"){1}, "%f %f");
%! assert (numel (line{1}), 321); assert (hypot (line{:}), ones (321, 1), 1e-3);
