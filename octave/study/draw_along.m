## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_along (@var{along}, @var{bodies}, @var{title}, @var{scratch})
## What the sections of rods bear (see @code{section_columns}) along their lengths, as along.svg and along.png beside
## the folder @var{scratch}, which takes the data: a panel a column, a curve each of the @var{bodies} (names).  They
## are there when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_along (along, bodies, title, scratch)
  [names, units] = section_columns (along);
  if (numel (bodies) == 1)
    bodies = {""};
  endif
  forces = vertcat (cellfun (@(body) [body.N; body.M], along, "uniformoutput", false){:});
  text = "";
  for k = 1:numel (names)
    values = cell2mat (cellfun (@(body) body.(names{k}), along, "uniformoutput", false));
    values(abs (values) < 1e-10*max (abs (forces))) = 0;  # rounding
    [scale, units{k}] = unit_prefix (values(isfinite (values)), units{k});
    part = linspace (0, 1, rows (values)).';
    text = [text, gnuplot_block(sprintf ("column_%d", k), {[part, values/scale]})];
  endfor
  labels = cellfun (@(name, unit) sprintf ("%s, %s", strrep (name, "M_normal", "M across"), unit), names, units, ...
                    "uniformoutput", false);
  settings = struct ("title", title, "labels", {labels}, "panels", numel (labels), "curves", numel (bodies), ...
                     "bodies", {bodies});
  write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), text]);
  job = start_gnuplot (scratch, "along.gp");
endfunction

%!test # one body, and two of which the second has no stress
%! body = struct ("N", rand (41, 1), "M", 1e4*rand (41, 1), "stress", 1e7*rand (41, 1));
%! for along = {{body}, {body, setfield(body, "stress", NaN (41, 1))}}
%!   [folder, gone] = scratch_folder ();
%!   draw = {@(scratch) draw_along(along{1}, {"it's a \"rod\"", "b"}(1:numel (along{1})), "a_b", scratch)};
%!   assert (draw_files (folder, draw, {"along.svg", "along.png"}), cell (0, 2));
%! endfor
