## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} spaced_labels (@var{rows})
## Take the labels from those @var{rows} (seconds, error_m, label, chosen) of a chart with logarithmic axes that would
## cover another one's.  The chosen one keeps its own.
## @end deftypefn

function rows = spaced_labels (rows)
  named = zeros (0, 2);
  [~, order] = sort (! [rows.chosen]);
  for k = order
    place = log10 ([rows(k).seconds, rows(k).error_m]);
    if (any (all (abs (named - place) < [0.12 0.4], 2)))
      rows(k).label = "";
    elseif (! isempty (rows(k).label))
      named(end+1,:) = place;
    endif
  endfor
endfunction

%!test
%! rows = struct ("seconds", {1 1.1 1.1 9}, "error_m", {1 1 1e-3 1}, "label", {"a" "b" "c" "d"}, ...
%!                "chosen", {false true false false});
%! assert ({spaced_labels(rows).label}, {"", "b", "c", "d"});
