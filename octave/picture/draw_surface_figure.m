## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_surface_figure (@var{drawing}, @var{scratch})
## As @code{draw_figure3}, of a drawing with a @code{surface} (see @code{draw_surface_frames}): the rod at up to nine
## even times, the last one the thickest.
## @end deftypefn

function job = draw_surface_figure (drawing, scratch)
  frames = numel (drawing.time);
  write_surface_settings (drawing, scratch, "svg png pdf");
  write_text (fullfile (scratch, "1.gp"), ...
              surface_frame_data (drawing, equally_spaced (frames, 9), "../figure3"));
  job = start_gnuplot (scratch, "surface.gp");
endfunction

%!function check_files (folder, scratch)
%!  finish_tool (draw_surface_figure (sample_surface (3), scratch));
%!  for kind = {"svg", "png", "pdf"}
%!    assert (stat (fullfile (folder, ["figure3." kind{1}])).size > 3000);
%!  endfor
%!endfunction
%!test in_scratch (@check_files);
