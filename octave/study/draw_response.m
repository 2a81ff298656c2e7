## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_response (@var{found}, @var{title}, @var{scratch})
## What @code{frequency_response} has @var{found} as response.svg and response.png beside the folder @var{scratch},
## which takes the data: amplitudes against the frequency, the six largest curves by name.  They are there when
## @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_response (found, title, scratch)
  [names, amplitude] = response_curves (found);
  shown = found.f > 0;  # the axis of frequencies is logarithmic
  [f, amplitude] = deal (found.f(shown), amplitude(:,shown));
  [~, order] = sort (max (amplitude, [], 2), "descend");
  order = order(max (amplitude(order,:), [], 2) > 0);
  if (numel (order) > 6)
    title = sprintf ("%s: the six largest of %d curves", title, numel (order));
    order = order(1:6);
  endif
  text = gnuplot_settings (struct ("title", title, "names", {names(order)}, "curves", numel (order), ...
                                   "f", f([1 end])));
  for k = 1:numel (order)
    drawn = amplitude(order(k),:);
    drawn(drawn == 0) = NaN;
    text = [text, gnuplot_block(sprintf ("curve_%d", k), {[f; drawn].'})];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "response.gp");
endfunction

%!function text = text_of (found, folder, scratch)
%!  finish_tool (draw_response (found, "Pulled", scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!  assert ([is_whole(fullfile (folder, "response.svg")), is_whole(fullfile (folder, "response.png"))], [true true]);
%!endfunction
%!test
%! found = struct ("f", [1 2 3], "response", rand (2, 1, 3), "inputs", {{"pull [N]"}}, ...
%!                 "outputs", {{"x [m]", "y [m]"}});
%! text = in_scratch (@(folder, scratch) text_of (found, folder, scratch));
%! assert (regexp (text, 'f_(?:low|high) = (\S+)', "tokens"), {{"1"}, {"3"}}); assert (numel (strfind (text, "$curve_")), 2);
%! found = struct ("f", [0 2], "response", cat (3, NaN, 1i), "inputs", {{"pull [N]"}}, "outputs", {{"x [m]"}});
%! text = in_scratch (@(folder, scratch) text_of (found, folder, scratch));  # one, a point
%! assert (regexp (text, 'f_(?:low|high) = (\S+)', "tokens"), {{"2"}, {"2"}});
%! [found.response, found.outputs] = deal (cat (3, (1:7).', (1:7).'), num2cell ("a":"g"));
%! text = in_scratch (@(folder, scratch) text_of (found, folder, scratch));
%! assert (! isempty (strfind (text, "Pulled: the six largest of 7 curves")));
