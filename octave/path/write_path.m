## -*- texinfo -*-
## @deftypefn {} {} write_path (@var{found}, @var{folder})
## What @code{load_path} has @var{found} as path.csv: a row a point of the factor, the square of the slowest undamped
## vibration (negative: it grows), whether it is stable, the event there, and places of each rod (see
## @code{path_places}).
## @end deftypefn

function write_path (found, folder)
  [names, places] = path_places (found.shape);
  whats = [{""}, {found.events.what}];
  heads = [{"factor", "square of the slowest [1/s^2]", "stable", "event"}, strcat(names, " [m]")];
  cells = [num2cell([found.factor; found.square; found.stable]); whats(1 + found.event); num2cell(places)].';
  write_csv (fullfile (folder, "path.csv"), heads, cells);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! found = struct ("factor", [0 0.5], "square", [2 0], "stable", [true true], "event", [0 1], "shape", ...
%!                 {{cat(3, [0 0; 1 2; 3 4], [0 0; 5 6; 7 8])}}, "events", struct ("what", "limit point"));
%! write_path (found, folder);
%! assert (fileread (fullfile (folder, "path.csv")), ...
%!         ["factor,square of the slowest [1/s^2],stable,event,mid_x [m],mid_y [m],tip_x [m],tip_y [m]\n" ...
%!          "0,2,1,,1,2,3,4\n0.5,0,1,limit point,5,6,7,8\n"]);
