## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_choices (@var{table}, @var{scratch})
## Estimated against true errors of the @var{table} of @code{verify_choices}, a point a scene, in tolerances, and the
## band that is promised: choices.svg and choices.png beside the folder @var{scratch}, which takes the data, when
## @var{job} has ended (see @code{finish_tool}).  What is below a thousandth is drawn there.
## @end deftypefn

function job = draw_choices (table, scratch)
  ran = table(isfinite ([table.error]) & isfinite ([table.estimate]));
  sorts = unique ({ran.sort});
  text = gnuplot_settings (struct ("sorts", {sorts}, "scenes", numel (table), "good", sum ([table.good]), ...
                                   "largest", max ([ran.error, 0])));
  for k = 1:numel (sorts)
    own = ran(strcmp ({ran.sort}, sorts{k}));
    text = [text, gnuplot_block(sprintf ("sort_%d", k), {max([own.error; own.estimate].', 1e-3)})];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "choices.gp");
endfunction

%!function text = drawn (folder, scratch)
%!  table = struct ("sort", {"rod", "surface", "rod", "none"}, "error", {0.5, 0.1, 0, Inf}, ...
%!                  "estimate", {0.25, 0.4, 1e-9, NaN}, "good", {true, true, true, false});
%!  finish_tool (draw_choices (table, scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!  assert (stat (fullfile (folder, "choices.png")).size > 10000);
%!endfunction
%!test # a block a sort; what is too small to be seen stands at the edge
%! text = in_scratch (@drawn);
%! assert (! isempty (strfind (text, "$sort_1 << END\n0.5 0.25 \n0.001 0.001 \nEND")));
%! assert (! isempty (strfind (text, "$sort_2 << END\n0.1 0.4 \nEND")));
%! assert (! isempty (strfind (text, "scenes = 4\ngood = 3\n")));
