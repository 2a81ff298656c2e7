## -*- texinfo -*-
## @deftypefn {} {} write_response (@var{found}, @var{folder})
## What @code{frequency_response} has @var{found}, as response.csv: a row a frequency, the amplitude and the phase
## (rad) of each output by each input.
## @end deftypefn

function write_response (found, folder)
  [names, amplitude] = response_curves (found);
  phase = reshape (arg (found.response), [], numel (found.f));
  heads = [names(:).'; repmat({"phase [rad]"}, 1, rows (phase))];
  table = [found.f; reshape([amplitude; phase](reshape (1:2*rows (phase), [], 2).',:), [], numel (found.f))];
  write_csv (fullfile (folder, "response.csv"), [{"f [Hz]"}, heads(:).'], table.');
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! found = struct ("f", [1 2], "response", cat (3, [1; 2i], [3; -4]), "inputs", {{"\"a\" [N]"}}, ...
%!                 "outputs", {{"tip_x [m]", "tip_y [m]"}});
%! write_response (found, folder);
%! assert (strsplit (fileread (fullfile (folder, "response.csv")), "\n"){1}, ...
%!         'f [Hz],"tip_x [m] by ""a"" [N]",phase [rad],"tip_y [m] by ""a"" [N]",phase [rad]');
%! assert (csvread (fullfile (folder, "response.csv"), 1, 0), [1 1 0 2 pi/2; 2 3 0 4 pi], 1e-12);
