## -*- texinfo -*-
## @deftypefn {} {} draw_surface_history (@var{scene}, @var{history}, @var{scratch})
## The time histories of a rod on a surface (see @code{measure_surface}), @file{history.svg} beside the folder @var{scratch},
## which takes the data.
## @end deftypefn

function draw_surface_history (scene, history, scratch)
  panels = {"tip, m", "x y z", history.tip
            "reaction, N/m", "smallest largest", [min(history.reaction, [], 1); max(history.reaction, [], 1)]
            "energies, J", "T U Z W", [history.T; history.U; history.Z; history.W]
            "energy balance, J", "T+U+Z-W", history.balance - history.balance(1)
            "angular momentum, kg m²/s", "x y z", history.angular_momentum};
  inside = scene.moment_breaks > 0 & scene.moment_breaks < history.t(end);
  settings = struct ("title", scene.title, "title_size", min (20, 1500/numel (scene.title)), "t", padded_range (history.t), ...
                     "panels", rows (panels), "breaks", sprintf ("%.9g ", scene.moment_breaks(inside)));
  write_text (fullfile (scratch, "settings.gp"), gnuplot_settings (settings));
  for i = 1:rows (panels)
    [label, names, values] = panels{i,:};
    panel = struct ("label", label, "names", names, "range", padded_range (values), "step", tic_step (padded_range (values), 5));
    write_text (fullfile (scratch, sprintf ("panel_%d.gp", i)), ...
                [gnuplot_settings(panel), gnuplot_block("curves", {[history.t; values].'})]);
  endfor
  run_gnuplot (scratch, "history.gp");
endfunction

%!test
%! folder = tempname (); mkdir (folder); mkdir (fullfile (folder, "scratch")); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = [1 2 4];
%!   history = struct ("t", [0 1 2], "tip", [row; row; row], "reaction", [row; row], "T", row, "U", row, "Z", row, "W", row, ...
%!                     "balance", row, "angular_momentum", [row; row; row]);
%!   draw_surface_history (struct ("title", "rod", "moment_breaks", 1), history, fullfile (folder, "scratch"));
%!   assert (! isempty (strfind (fileread (fullfile (folder, "history.svg")), "reaction, N/m")));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
