## -*- texinfo -*-
## @deftypefn {} {@var{cells} =} sweep_sensitivity (@var{plan}, @var{found})
## How much each observed number of a random sweep depends on each of its fields: of a @var{plan} (see
## @code{plan_sweep}) and what was @var{found} (see @code{gather_rows}), a row each of observation, field, number of
## points, standardised regression coefficient, R^2 (see @code{regression_coefficients}), index of first order and its
## standard error (see @code{sobol_indices}).  The index is NaN where points failed: the others are no longer spread
## evenly.  There are no rows where the points are not random, or nothing is a number.
## @end deftypefn

function cells = sweep_sensitivity (plan, found)
  cells = cell (0, 7);
  done = found.done(:);
  if (isempty (plan.settings.random) || sum (done) < 2)
    return;
  endif
  [~, lists] = read_vary (plan.settings.vary, "VARY");
  ranges = [lists{:}];
  ranges = [ranges{:}];
  x = cell2mat (plan.values(done,:));
  y = str2double (found.observed(done,:));
  for k = find (all (isfinite (y), 1))
    [beta, share] = regression_coefficients (x, y(:,k));
    [index, spread] = deal (NaN (size (beta)), NaN (size (beta)));
    if (all (done))
      [index, spread] = sobol_indices (2*(x - [ranges.low])./([ranges.high] - [ranges.low]) - 1, y(:,k));
    endif
    for j = 1:numel (beta)
      cells(end+1,:) = {plan.items(k).text, plan.columns{j}, sum(done), beta(j), share, index(j), spread(j)};
    endfor
  endfor
endfunction

%!function [plan, found] = random_plan ()
%!  plan.settings = struct ("vary", "a=0..2; b=10..30", "random", 50, "seed", 1);
%!  ranges = struct ("low", {0, 10}, "high", {2, 30});
%!  x = latin_hypercube (ranges, 50, 1);
%!  [plan.columns, plan.values, plan.items] = deal ({"a", "b"}, num2cell (x), struct ("text", {"u", "model", "w"}));
%!  found.done = true (50, 1);
%!  found.observed = [arrayfun(@(a, b) sprintf ("%.17g", 20*a + b), x(:,1), x(:,2), "uniformoutput", false), ...
%!                    repmat({"rigid"}, 50, 1), repmat({"7"}, 50, 1)];
%!endfunction
%!test
%! [plan, found] = random_plan ();
%! cells = sweep_sensitivity (plan, found);
%! assert (cells(:,1:3), {"u", "a", 50; "u", "b", 50; "w", "a", 50; "w", "b", 50});
%! x = cell2mat (plan.values);
%! assert (cell2mat (cells(1:2,4)).', [20 1].*std (x)/std (x*[20; 1]), 1e-10); assert ([cells{1:2,5}], [1 1], 1e-10);
%! assert (cell2mat (cells(1:2,[6 7])), [0.8 0; 0.2 0], 1e-8);
%! assert (cell2mat (cells(3:4,4:7)), NaN (2, 4));
%! squares = found;  # with s and r from -1 to 1, s^2 + r/2, whose parts have the variances 4/45 and 1/12
%! squares.observed(:,1) = arrayfun (@(a, b) sprintf ("%.17g", (a - 1)^2 + b/20), x(:,1), x(:,2), "uniformoutput", false);
%! assert ([sweep_sensitivity(plan, squares){1:2,6}], [4/45 1/12]/(4/45 + 1/12), 1e-3);
%! found.done(3) = false; found.observed(3,:) = {""};
%! cells = sweep_sensitivity (plan, found);
%! assert (cell2mat (cells(1:2,[3 6 7])), [49 NaN NaN; 49 NaN NaN]);
%! assert (isfinite (cell2mat (cells(1:2,4))));
%! plan.settings.random = [];
%! assert (sweep_sensitivity (plan, found), cell (0, 7));
