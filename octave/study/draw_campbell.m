## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_campbell (@var{found}, @var{title}, @var{scratch})
## What @code{campbell} has @var{found} as Campbell's diagram, campbell.svg and campbell.png beside the folder
## @var{scratch}, which takes the data: branches, the lines of one to six excitations a turn, crosses where a branch
## grows.  They are there when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_campbell (found, title, scratch)
  count = rows (found.f);
  unstable = zeros (0, 2);
  text = gnuplot_settings (struct ("title", title, "branches", count, "highest", 1.05*max (found.f(:)), ...
                                   "fastest", max (found.speeds), "speeds", numel (found.speeds)));
  for k = 1:count
    text = [text, gnuplot_block(sprintf ("branch_%d", k), {[found.speeds; found.f(k,:)].'})];
    grows = found.growth(k,:) > 0;
    unstable = [unstable; [found.speeds(grows); found.f(k,grows)].'];
  endfor
  write_text (fullfile (scratch, "settings.gp"), [text, gnuplot_block("unstable", {[unstable; NaN NaN]})]);
  job = start_gnuplot (scratch, "campbell.gp");
endfunction

%!function text = settings_of (found, scratch)
%!  finish_tool (draw_campbell (found, "a rod", scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # the axis of the frequencies goes a twentieth beyond the highest
%! found = struct ("speeds", [0 2], "f", [1 3; 5 8], "growth", zeros (2));
%! text = in_scratch (@(folder, scratch) settings_of (found, scratch));
%! assert (regexp (text, '^highest = 8\.4$', "lineanchors") > 0);
%!test # with something unstable, and without
%! found = struct ("speeds", [0 2 4], "f", [1 3 4; 5 7 0], "growth", [0 0 0; 0 0 0.5]);
%! for given = {found, setfield(found, "growth", zeros (2, 3))}
%!   [folder, gone] = scratch_folder ();
%!   draw = {@(scratch) draw_campbell(given{1}, "it's a \"rod\"", scratch)};
%!   assert (draw_files (folder, draw, {"campbell.svg", "campbell.png"}), cell (0, 2));
%! endfor
