## -*- texinfo -*-
## @deftypefn {} {} draw_map (@var{folder})
## Draw map.svg and map.png in the @var{folder} (default output): the folders of octave/ with their files, each below
## those that call it, and a lane for each that is called.  A line from a folder meets the lanes of what it calls in
## dots, with the number of calls; the lane ends at its folder.
## @end deftypefn

function draw_map (folder = "output")
  [calls, files] = call_graph ();
  [number, folders] = folder_calls (calls);
  order = callers_first (number);
  [paths, names] = cellfun (@fileparts, unique ([files, {calls.called}]), "UniformOutput", false);
  boxes = struct ("folder", folders(order), "names", {{}});
  for k = 1:numel (boxes)
    boxes(k).names = names(strcmp (paths, boxes(k).folder));
  endfor
  publish_study (struct ("folder", folder, "pictures", true), {}, {"map.svg", "map.png"}, @(aside) 0, ...
                 @(scratch) start (scratch, boxes, number(order,order)));
endfunction

## folders by the longest way to them from one that none calls
function order = callers_first (number)
  level = zeros (1, rows (number));
  for k = 1:rows (number)
    level = max ((level + 1).'.*(number > 0), [], 1);
  endfor
  [~, order] = sort (level);
endfunction

function job = start (scratch, boxes, number)
  here = fileparts (mfilename ("fullpath"));
  look = fullfile (fileparts (which ("start_gnuplot")), "look.gp");
  [text, size] = layout (boxes, number);
  write_text (fullfile (scratch, "drawing.gp"), text);
  write_text (fullfile (scratch, "settings.gp"), gnuplot_settings (struct ("look", look, "width", size(1), ...
                                                                           "height", size(2))));
  job = start_tool (scratch, "gnuplot", ["gnuplot -d " shell_string(fullfile (here, "map.gp"))]);
endfunction

## objects, arrows and labels of gnuplot in pixels, downwards
function [text, size] = layout (boxes, number)
  called = any (number, 1);
  right = 1100;
  lanes = right + 40 + 36*(cumsum (called) - 1);
  palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
  top = 150;
  text = "";
  for k = 1:numel (boxes)
    colours{k} = sprintf ("rgb '%s'", palette{1 + mod(k, end)});
    [box, bottom] = box_of (boxes(k), top, right, colours{k});
    text = [text, box];
    in(k) = top + 12;
    out(k) = bottom - 10;
    top = bottom + 12;
  endfor
  for c = find (any (number, 2)).'
    last = max (lanes(number(c,:) > 0));
    text = [text, sprintf("set arrow from %d,%d to %d,%d nohead lc rgb ink\n", right, out(c), last, out(c))];
  endfor
  for k = find (called)
    callers = find (number(:,k)).';
    text = [text, sprintf("set arrow from %d,140 to %d,%d nohead lw 1.5 lc %s\n", lanes(k), lanes(k), ...
                          max ([out(callers), in(k)]), colours{k}), ...
            sprintf("set arrow from %d,%d to %d,%d head filled size 9,18 lw 2 lc %s\n", lanes(k), in(k), right, ...
                    in(k), colours{k}), ...
            label(lanes(k), 135, boxes(k).folder, ["small rotate by 45 tc " colours{k}])];
    for c = callers
      radius = 3 + sqrt (number(c,k))/2;
      text = [text, sprintf("set object circle at %d,%d size %g fc %s fs solid noborder front\n", lanes(k), out(c), ...
                            radius, colours{k}), ...
              label(lanes(k) + radius + 1, out(c) - 8, sprintf ("%d", number(c,k)), "small")];
    endfor
  endfor
  size = [lanes(end) + 80, top + 5];
endfunction

## a folder with the names of its files in columns
function [text, bottom] = box_of (box, top, right, colour)
  left = 15;
  columns = floor ((right - left)/(6.2*max (cellfun (@numel, box.names)) + 16));
  lines = ceil (numel (box.names)/columns);
  bottom = top + 28 + max (16*lines, 20);
  text = [sprintf("set object rectangle from %d,%d to %d,%d fc rgb '#f6f6f6' fs solid border lc %s\n", ...
                  left, top, right, bottom, colour), ...
          label(left + 8, top + 12, box.folder, ["large tc " colour])];
  for k = 1:numel (box.names)
    x = left + 8 + (right - left)/columns*floor ((k - 1)/lines);
    text = [text, label(x, top + 32 + 16*mod (k - 1, lines), box.names{k}, "small")];
  endfor
endfunction

function text = label (x, y, words, style)
  text = sprintf ("set label %s at %g,%g font %s\n", gnuplot_string (words), x, y, style);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! said = evalc ("draw_map (folder)");
%! assert (said, [folder "/ has map.svg, map.png\n"]);
%! assert (! isempty (regexp (fileread (fullfile (folder, "map.svg")), 'write_text.*octave/messages', "once")));
