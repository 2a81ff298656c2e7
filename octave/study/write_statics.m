## -*- texinfo -*-
## @deftypefn {} {} write_statics (@var{found}, @var{time}, @var{folder})
## What @code{statics} has @var{found} at the @var{time} (s): shape.csv, the places of each rod, and statics.csv,
## figures by name.
## @end deftypefn

function write_statics (found, time, folder)
  heads = {"body", "part of the length", "x [m]", "y [m]", "z [m]"}(1:2 + columns (found.shape{1}));
  table = zeros (0, numel (heads));
  for k = 1:numel (found.shape)
    places = found.shape{k};
    part = linspace (0, 1, rows (places)).';
    table = [table; repmat(k, rows (places), 1), part, places];
  endfor
  write_csv (fullfile (folder, "shape.csv"), heads, table);
  figures = {"time [s]", time; "stable", double(found.stable); "slowest vibration [rad/s]", found.slowest
             "growth [1/s]", max(found.vibrations.rate); "base functions of each sort", found.functions
             "relative change by doubling them", max(found.change)};
  write_csv (fullfile (folder, "statics.csv"), {"figure", "value"}, [figures; found.supports], 1);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! found = struct ("shape", {{[0 0; 1 2], [1 2; 3 4]}}, "stable", true, "slowest", 3, "vibrations", ...
%!                 struct ("rate", [0 0]), "functions", 8, "change", [0 1e-9], "supports", {{"reaction_x [N]", 6}});
%! write_statics (found, 0.5, folder);
%! assert (fileread (fullfile (folder, "shape.csv")), ...
%!         "body,part of the length,x [m],y [m]\n1,0,0,0\n1,1,1,2\n2,0,1,2\n2,1,3,4\n");
%! text = fileread (fullfile (folder, "statics.csv"));
%! assert (! isempty (strfind (text, "\n\"reaction_x [N]\",6\n")));
%! assert (! isempty (strfind (text, "\"time [s]\",0.5\n")));
