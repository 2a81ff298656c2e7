## -*- texinfo -*-
## @deftypefn {} {@var{counts} =} all_pairs (@var{kind}, @var{base}, @var{choices}, @var{most})
## Run scenes of a @var{kind} in which each pair of values of the @var{choices} (see @code{rod_choices}) occurs, at
## @var{most} so many scenes (default: all).  A scene that does not run is made smaller until only the values are left
## that it takes; these are printed with what was said, and the other pairs are tried without them.
##
## @var{counts} is a struct of scenes, pairs, ran, refused (pairs) and faults: sets of values that end in an error of
## Octave's own, or in something wrong.
## @end deftypefn

function counts = all_pairs (kind, base, choices, most = Inf)
  factor_of = cumsum ([true, ! strcmp(choices(2:end,1), choices(1:end-1,1)).']);
  first = arrayfun (@(factor) find (factor_of == factor, 1), 1:max (factor_of));
  open = factor_of != factor_of.';
  counts = struct ("scenes", 0, "pairs", sum (open(:))/2, "ran", 0, "refused", 0, "faults", 0);
  causes = {};
  while (any (open(:)) && counts.scenes < most)
    show_progress (sprintf ("%s: %d pairs are left", kind, sum (open(:))/2));
    row = next_row (open, factor_of, causes);
    [outcome, message] = try_scene (scene_of (base, choices, row));
    counts.scenes++;
    before = sum (open(:))/2;
    if (strcmp (outcome, "ran"))
      open(row,row) = false;
      counts.ran += before - sum (open(:))/2;
    else
      same = @(row) is_same (scene_of (base, choices, row), outcome, message);
      cause = smallest_cause (row, first, same);
      if (! any (cellfun (@(known) isequal (known, cause), causes)))
        counts.faults += report (kind, outcome, choices(cause,:), message);
        causes{end+1} = cause;
      else  # the row could not be had without it
        [i, j] = find (open, 1);
        causes{end+1} = cause = [i, j];
      endif
      open = without (open, cause);
      counts.refused += before - sum (open(:))/2;
    endif
  endwhile
  show_progress ("");
endfunction

function open = without (open, cause)
  if (numel (cause) == 1)
    open(cause,:) = open(:,cause) = false;
  elseif (numel (cause) == 2)
    open(cause,cause) = false;
  endif
endfunction

function scene = scene_of (base, choices, row)
  scene = base;
  for k = row
    change = choices{k,3};
    if (is_function_handle (change))
      scene = change (scene);
    else
      for pair = reshape (change, 2, [])
        scene = setfield (scene, strsplit (pair{1}, "."){:}, pair{2});
      endfor
    endif
  endfor
endfunction

## the same outcome, in the same words
function yes = is_same (scene, outcome, message)
  [other, said] = try_scene (scene);
  yes = strcmp (other, outcome) && strcmp (words_of (said), words_of (message));
endfunction

function text = words_of (text)
  text = regexprep (text, '[-+]?\d[\d.e+-]*', "#");
endfunction

function fault = report (kind, outcome, values, message)
  fault = any (strcmp (outcome, {"internal", "wrong"}));
  names = strjoin (strcat (values(:,1), {" = "}, values(:,2)).', ", ");
  verdict = "ok";
  if (fault)
    verdict = "not ok";
  endif
  printf ("%s %s: %s: %s: %s\n", verdict, kind, names, outcome, message);
  fflush (stdout);
endfunction

%!function scene = changed (scene, path, value)
%!  scene = setfield (scene, path{:}, value);
%!endfunction
%!test # one pair of values does not go together: it is named, the seven other pairs have run
%! base = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.015), "duration", 0.02, ...
%!                "model", struct ("modes", [0 0]), "solver", struct ());
%! choices = {"moment", "none", {}; "moment", "some", {"moment", 1}
%!            "rotation", "none", {}; "rotation", "some", {"rotation", @(t) [0 0 0]}
%!            "tip mass", "none", {}; "tip mass", "some", {"tip_mass", 1}};
%! rand ("twister", 1);
%! said = evalc ('counts = all_pairs ("rod", base, choices);');
%! assert (said, ["ok rod: moment = some, rotation = some: refused: moment and rotation are both given: a hub that" ...
%!                " prescribes the rotation takes any moment at O\n"]);
%! assert ([counts.pairs, counts.ran, counts.refused, counts.faults], [12 11 1 0]);
