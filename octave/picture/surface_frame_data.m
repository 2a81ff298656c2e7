## -*- texinfo -*-
## @deftypefn {} {@var{text} =} surface_frame_data (@var{drawing}, @var{shown}, @var{name})
## What a picture with the @var{name} shows of a drawing with a @code{surface} (see @code{draw_surface_frames}), for
## gnuplot: the rod at the frames @var{shown}, the path of its end up to the last of them, its ends that are held, and
## springs and forces in the last.
## @end deftypefn

function text = surface_frame_data (drawing, shown, name)
  last = shown(end);
  rod = drawing.surface.rod;
  settings = struct ("name", name, "clock", clock_text (drawing, last), "rods", numel (shown), ...
                     "elevation", 90 - drawing.surface.elevation, ...
                     "azimuth", mod (90 + drawing.surface.azimuth(last), 360));
  rods = arrayfun (@(k) [rod.x(:,k), rod.y(:,k), rod.z(:,k)], shown, "uniformoutput", false);
  behind = max (1, last - 3000):last;  # of a long run not all, since each frame draws it
  tip = [rod.x(end,behind); rod.y(end,behind); rod.z(end,behind)].';
  ends = [1, rows(rod.x)](drawing.surface.held);
  held = [rod.x(ends,last), rod.y(ends,last), rod.z(ends,last)];
  text = [gnuplot_settings(settings), gnuplot_block("rod", rods), gnuplot_block("tip", {tip([1:end, end],:)}), ...
          gnuplot_block("held", {[held; NaN(1, 3)]}), lines_of(drawing.surface, last)];
endfunction

function text = lines_of (surface, frame)
  [springs, forces] = lines_in_space (surface);
  at = @(lines, prefix) [lines.([prefix "x"])(:,frame), lines.([prefix "y"])(:,frame), lines.([prefix "z"])(:,frame)];
  [from, to] = deal (at (springs, ""), at (springs, "to_"));
  size = range (surface.patch.x(:))/100;
  coils = arrayfun (@(k) [coil(from(k,:), to(k,:), size); NaN(1, 3)], 1:rows (from), "uniformoutput", false);
  arrows = [at(forces, ""), at(forces, "to_") - at(forces, "")];
  text = [gnuplot_block("springs", {vertcat(coils{:}, NaN (1, 3))}), gnuplot_block("forces", {[arrows; NaN(1, 6)]})];
endfunction

## six turns between straight ends
function line = coil (from, to, size)
  way = to - from;
  across = size*null (way).';
  angle = linspace (0, 12*pi, 97).';
  line = [from; from + (0.15 + 0.7*angle/(12*pi)).*way + cos(angle).*across(1,:) + sin(angle).*across(2,:); to];
endfunction

%!test
%! text = surface_frame_data (sample_surface (3), [1 3], "../frames/frame_0001");
%! assert (! isempty (strfind (text, "rods = 2")));
%!test # an end that is held is marked, in its place
%! drawing = sample_surface (2);
%! drawing.surface.held = [true false];
%! text = surface_frame_data (drawing, 1, "a");
%! start = sscanf (regexp (text, '\$held << END\n([^\n]*)', "tokens"){1}{1}, "%f").';
%! assert (start, [drawing.surface.rod.x(1,1), drawing.surface.rod.y(1,1), drawing.surface.rod.z(1,1)], 1e-6);
%!test # the camera, the rods at their times, and the tip's way until the last of them
%! drawing = sample_surface (4);
%! drawing.surface.elevation = 35;
%! drawing.surface.azimuth = [0 90 180 300];
%! text = surface_frame_data (drawing, [1 3], "a");
%! for line = {"name = 'a'", "elevation = 55", "azimuth = 270", ["clock = '" clock_text(drawing, 3) "'"]}
%!   assert (numel (strfind (text, [line{1} "\n"])) == 1, "%s", line{1});
%! endfor
%! assert (! isempty (strfind (surface_frame_data (drawing, 4, "a"), "azimuth = 30\n")));
%! block = @(text, name) regexp (text, ['\$' name ' << END\n(.*?)\nEND'], "tokens", "once"){1};
%! rod = drawing.surface.rod;
%! tip = [rod.x(end,1:3); rod.y(end,1:3); rod.z(end,1:3)].';
%! assert (str2num (block (text, "tip")), tip([1:3, 3],:), 1e-6);
%! rods = strsplit (block (text, "rod"), "\n\n\n");
%! assert (numel (rods), 2); assert (str2num (rods{2}), [rod.x(:,3), rod.y(:,3), rod.z(:,3)], 1e-6);
%! long = sample_surface (2);
%! for axis = "xyz"
%!   long.surface.rod.(axis) = (1:3500).*[1; 1];
%! endfor
%! long.time = (1:3500)/50;
%! long.surface.azimuth = zeros (1, 3500);
%! assert (str2num (block (surface_frame_data (long, 3400, "a"), "tip"))([1 end],1), [400; 3400]);
%!test # a spring's turns between its ends, and a force's arrow
%! drawing = sample_surface (2);
%! drawing.surface.springs = struct ("x", [0 1], "y", [0 1], "z", [1 1], "to_x", [1 1], "to_y", [2 2], "to_z", [3 3]);
%! drawing.surface.forces = struct ("x", [5 1], "y", [6 1], "z", [7 1], "F_x", [0 0], "F_y", [0 0], "F_z", [9 0]);
%! text = surface_frame_data (drawing, 1, "a");
%! coil = sscanf (regexp (text, '\$springs << END\n(.*?)\n\n', "tokens", "once"){1}, "%f", [3, Inf]).';
%! assert (coil([1 end],:), [0 0 1; 1 2 3]);
%! off = (coil(2:end-1,:) - [0 0 1])*null ([1 2 2]);
%! assert (hypot (off(:,1), off(:,2)), 0.04*ones (97, 1), 1e-6);
%! assert (sscanf (regexp (text, '\$forces << END\n([^\n]*)', "tokens", "once"){1}, "%f").', [5 6 6 0 0 1], 1e-6);
