## -*- texinfo -*-
## @deftypefn {} {} write_modes (@var{rows}, @var{names}, @var{folder})
## The @var{rows} of @code{natural_modes} as modes.csv; @var{names} are those of the bodies.
## @end deftypefn

function write_modes (rows, names, folder)
  heads = [{"mode", "f [Hz]", "omega [rad/s]", "damping ratio", "growth [1/s]", "change"}, ...
           strcat({"share of "}, names)];
  table = [rows.mode; rows.f; rows.omega; rows.damping; rows.growth; rows.change; vertcat(rows.share).'].';
  write_csv (fullfile (folder, "modes.csv"), heads, table);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! row = struct ("mode", 2, "f", 0.5, "omega", pi, "damping", 0.1, "growth", 0, "change", 1e-8, "share", [0.25 0.75]);
%! write_modes (row, {"a", "b"}, folder);
%! lines = strsplit (fileread (fullfile (folder, "modes.csv")), "\n");
%! assert (lines{1}, "mode,f [Hz],omega [rad/s],damping ratio,growth [1/s],change,share of a,share of b");
%! assert (lines{2}, "2,0.5,3.1415926535897931,0.10000000000000001,0,1e-08,0.25,0.75");
