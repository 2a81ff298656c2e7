## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_sweep (@var{sweep}, @var{title}, @var{scratch})
## What a @var{sweep} has observed, a panel each of the first six that have numbers, sweep.svg and sweep.png beside the
## folder @var{scratch}, which takes the data: over one field curves, over two maps, with crosses where points failed.
## They are there when @var{job} has ended (see @code{finish_tool}).  @var{sweep} is a struct of x and names (see
## @code{drawn_sweep}), y (a column an observable, NaN where there is none), texts (cellstr, one each) and failed.
## @end deftypefn

function job = draw_sweep (sweep, title, scratch)
  shown = find (any (isfinite (sweep.y), 1));
  shown = shown(1:min (end, 6));
  [x, order] = sortrows (sweep.x);
  y = sweep.y(order,shown);
  axes = numel (sweep.names);
  columns = 1 + (numel (shown) > 1 && axes == 2);
  settings = struct ("title", title, "names", {sweep.names}, "texts", {sweep.texts(shown)}, "fields", axes, ...
                     "grid", axes == 2 && is_grid (x), "across", columns, "down", ceil (numel (shown)/columns), ...
                     "finer", {num2cell(arrayfun (@(j) ceil (30/numel (unique (x(:,j)))), 1:axes))}, ...
                     "step", step_of (x(:,1)), ...
                     "logs", {num2cell(double (arrayfun (@(j) is_wide (x(:,j)), 1:axes)))});
  text = gnuplot_settings (settings);
  for k = 1:numel (shown)
    text = [text, gnuplot_block(sprintf ("panel_%d", k), {with_breaks([x, y(:,k)], settings.grid)})];
  endfor
  failed = [sweep.x(sweep.failed,:), zeros(sum (sweep.failed), 1); NaN(1, axes + 1)];
  write_text (fullfile (scratch, "settings.gp"), [text, gnuplot_block("failed", {failed})]);
  job = start_gnuplot (scratch, "sweep.gp");
endfunction

## all combinations of two lists of values
function yes = is_grid (x)
  lists = {unique(x(:,1)), unique(x(:,2))};
  yes = rows (x) == numel (lists{1})*numel (lists{2}) && rows (unique (x, "rows")) == rows (x);
endfunction

## of five tics at most, which a narrow panel has room for
function step = step_of (x)
  step = 1;
  if (range (x) > 0)
    step = tic_step ([min(x), max(x)], 5);
  endif
endfunction

## a blank line between the rows of a grid, and what has no value as gnuplot's own word for it, not as a break
function table = with_breaks (table, grid)
  table(! isfinite (table)) = 1e300;  # above what any axis shows; sweep.gp leaves it out
  if (grid)
    ends = find (diff (table(:,1)) != 0);
    for k = flipud (ends).'
      table = [table(1:k,:); NaN(1, columns (table)); table(k+1:end,:)];
    endfor
  endif
endfunction

%!function missing = drawn (folder, sweep)
%!  draw = @(scratch) draw_sweep (sweep, "it's a \"rod\"", scratch);
%!  missing = draw_files (folder, {draw}, {"sweep.svg", "sweep.png"});
%!endfunction
%!test # one field, two on a grid and at random places, with and without failures
%! [a, b] = meshgrid (1:3, [1 10 1000]);
%! grid = struct ("x", [a(:), b(:)], "names", {{"a_b", "c"}}, "y", [a(:).*b(:), NaN(9, 1), a(:)], ...
%!                "texts", {{"max|y| [m]", "model", "last psi"}}, "failed", false (9, 1));
%! broken = grid; broken.failed(4) = true; broken.y(4,:) = NaN;
%! loose = broken; loose.x(:,1) += 0.1*(1:9).';
%! curve = broken; curve.x = (1:9).'; curve.names = {"a"};
%! for sweep = {grid, broken, loose, curve}
%!   assert (in_scratch (@(folder, scratch) drawn (folder, sweep{1})), cell (0, 2));
%! endfor
%!function text = drawn_settings (scratch, sweep)
%!  finish_tool (draw_sweep (sweep, "", scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # rows of a grid are apart, and each point is there once
%! sweep = struct ("x", [1 1; 1 2; 2 1; 2 2], "names", {{"a", "b"}}, "y", [5; 6; 7; 8], "texts", {{"y"}}, ...
%!                 "failed", false (4, 1));
%! text = in_scratch (@(folder, scratch) drawn_settings (scratch, sweep));
%! table = regexp (text, 'panel_1 << END\n(.*?)\n+END', "tokens", "once"){1};
%! assert (strrep (table, " \n", "\n"), "1 1 5\n1 2 6\n\n2 1 7\n2 2 8 ");
