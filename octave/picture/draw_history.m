## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_history (@var{drawing}, @var{scratch})
## The time histories of @var{drawing} (see @code{draw_pictures}), @file{history.svg} beside the folder @var{scratch},
## which takes the data. It is there when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_history (drawing, scratch)
  panels = drawing.panels;
  settings = scene_settings (drawing, fit_camera (drawing, [1 1]));
  settings.t = padded_range (drawing.time);
  settings.panels = numel (panels);
  inside = drawing.moment_breaks > drawing.time(1) & drawing.moment_breaks < drawing.time(end);
  settings.breaks = sprintf ("%.9g ", drawing.moment_breaks(inside));
  write_text (fullfile (scratch, "settings.gp"), gnuplot_settings (settings));
  for i = 1:numel (panels)
    [label, values] = scaled_panel (panels(i));
    panel = struct ("label", label, "names", strjoin (panels(i).names), ...
                    "range", padded_range (values), "step", tic_step (padded_range (values), 5));
    write_text (fullfile (scratch, sprintf ("panel_%d.gp", i)),
                [gnuplot_settings(panel), gnuplot_block("curves", {[drawing.time; values].'})]);
  endfor
  job = start_gnuplot (scratch, "history.gp");
endfunction

%!function text = history_of (drawing)
%!  folder = tempname ();
%!  mkdir (folder);
%!  mkdir (fullfile (folder, "scratch"));
%!  unwind_protect
%!    finish_tool (draw_history (drawing, fullfile (folder, "scratch")));
%!    text = fileread (fullfile (folder, "history.svg"));
%!  unwind_protect_cleanup
%!    confirm_recursive_rmdir (false, "local");
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction

%!test
%! text = history_of (sample_drawing (20));
%! for shown = {"energies, J", "V2_1", "largest modes, µm", "break of M", "ψ"}
%!   assert (! isempty (strfind (text, shown{1})), shown{1});
%! endfor
%!test # a single frame, and a break that is not in the picture
%! assert (isempty (strfind (history_of (sample_drawing (1)), "break of M")));
