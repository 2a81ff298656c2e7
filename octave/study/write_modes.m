## -*- texinfo -*-
## @deftypefn {} {} write_modes (@var{rows}, @var{names}, @var{folder})
## The @var{rows} of @code{natural_modes} as modes.csv; @var{names} are those of the bodies.
## @end deftypefn

function write_modes (rows, names, folder)
  text = ["mode,f [Hz],omega [rad/s],damping ratio,growth [1/s],change", sprintf(",share of %s", names{:}), "\n"];
  for row = rows
    text = [text, sprintf("%d", row.mode), sprintf(",%.17g", row.f, row.omega, row.damping, row.growth, row.change, ...
                                                   row.share), "\n"];
  endfor
  write_text (fullfile (folder, "modes.csv"), text);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! row = struct ("mode", 2, "f", 0.5, "omega", pi, "damping", 0.1, "growth", 0, "change", 1e-8, "share", [0.25 0.75]);
%! write_modes (row, {"a", "b"}, folder);
%! lines = strsplit (fileread (fullfile (folder, "modes.csv")), "\n");
%! assert (lines{1}, "mode,f [Hz],omega [rad/s],damping ratio,growth [1/s],change,share of a,share of b");
%! assert (lines{2}, "2,0.5,3.1415926535897931,0.10000000000000001,0,1e-08,0.25,0.75");
