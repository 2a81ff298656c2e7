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
%!test # places are apart by a third of the one, or by thrice of the other
%! for apart = {1.3, 1, {"a" ""}; 1.35, 1, {"a" "b"}; 1, 2.4, {"a" ""}; 1, 2.6, {"a" "b"}}.'
%!   rows = struct ("seconds", {1 apart{1}}, "error_m", {1 apart{2}}, "label", {"a" "b"}, "chosen", {false false});
%!   assert ({spaced_labels(rows).label}, apart{3});
%! endfor
%! rows = struct ("seconds", {1 1}, "error_m", {1 1}, "label", {"" "b"}, "chosen", {true false});
%! assert ({spaced_labels(rows).label}, {"", "b"});  # what has no label hides none
