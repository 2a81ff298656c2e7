## -*- texinfo -*-
## @deftypefn {} {} write_campbell (@var{found}, @var{folder})
## What @code{campbell} has @var{found} as campbell.csv: a row a speed, frequencies of all branches, their growth, and
## the least modal assurance criteria by which each was followed from the speed before.
## @end deftypefn

function write_campbell (found, folder)
  count = rows (found.f);
  numbered = @(template) arrayfun (@(k) sprintf (template, k), 1:count, "uniformoutput", false);
  heads = [{"speed [rad/s]"}, numbered("f_%d [Hz]"), numbered("growth_%d [1/s]"), numbered("MAC_%d")];
  write_csv (fullfile (folder, "campbell.csv"), heads, [found.speeds; found.f; found.growth; found.mac].');
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! found = struct ("speeds", [0 2], "f", [1 3; 5 7], "growth", [0 0; 0 0.5], "mac", [1 0.75; 1 0.5]);
%! write_campbell (found, folder);
%! assert (fileread (fullfile (folder, "campbell.csv")), ...
%!         ["speed [rad/s],f_1 [Hz],f_2 [Hz],growth_1 [1/s],growth_2 [1/s],MAC_1,MAC_2\n" ...
%!          "0,1,5,0,0,1,1\n2,3,7,0,0.5,0.75,0.5\n"]);
