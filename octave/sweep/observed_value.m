## -*- texinfo -*-
## @deftypefn {} {@var{value} =} observed_value (@var{item}, @var{names}, @var{table}, @var{tables})
## The number or text that an @var{item} of OBSERVE (see @code{read_observe}) has in a run: with columns of history.csv
## of such @var{names} (cellstr, with units), the @var{table} (names-by-times), and the struct @var{tables} of the
## summary and of what @code{verb_tables} gives.  What the summary leaves empty is NaN.
## @end deftypefn

function value = observed_value (item, names, table, tables)
  if (isfield (tables, item.part))
    value = of_fields (item, tables.(item.part));
    return;
  endif
  bare = regexprep (names, ' \[.*$', "");
  row = find (strcmp (item.name, bare));
  if (isempty (row))
    scene_error ("OBSERVE: history.csv has no column %s: those are %s", item.name, strjoin (bare, ", "));
  endif
  t = table(1,:);
  x = table(row,:);
  if (item.absolute)
    x = abs (x);
  endif
  switch (item.part)
    case {"max", "min", "range"}
      value = feval (item.part, x);
    case "mean"
      value = mean_over (t, x);
    case "rms"
      value = sqrt (mean_over (t, x.^2));
    case "first"
      value = x(1);
    case "last"
      value = x(end);
    case "at"
      value = at_time (t, x, item.time);
  endswitch
endfunction

function mean = mean_over (t, x)
  mean = x(1);
  if (numel (t) > 1)
    mean = trapz (t, x)/(t(end) - t(1));
  endif
endfunction

function value = at_time (t, x, time)
  if (! (time >= t(1) && time <= t(end)))
    scene_error ("OBSERVE: t = %g is not in the run, which is from %g to %g s", time, t(1), t(end));
  endif
  value = interp1 (t, x, time);
endfunction

function value = of_fields (item, table)
  value = table;
  place = strrep (item.part, "summary", "summary.json");
  for name = strsplit (item.name, ".")
    if (! (isstruct (value) && isscalar (value) && isfield (value, name{1})))
      scene_error ("OBSERVE: %s has no %s: it has %s", place, item.name, strjoin (fieldnames (table).', ", "));
    endif
    value = value.(name{1});
  endfor
  if (isempty (value) && ! ischar (value))
    value = NaN;
  elseif ((isnumeric (value) || islogical (value)) && item.index <= numel (value) && (item.index || isscalar (value)))
    value = double (value(max (item.index, 1)));
  elseif (! (ischar (value) && item.index == 0))
    scene_error ("OBSERVE: %s of %s is no number and no text, but a %s %s", item.text, place, ...
                 strjoin (arrayfun (@num2str, size (value), "uniformoutput", false), "-by-"), class (value));
  endif
endfunction

%!function value = of (text, table = [0 1 3; 2 -4 0])
%!  summary = struct ("model", "rigid", "modes", [0 7], "none", [], "list", {{1}}, "seconds", struct ("total", 3), ...
%!                    "yes", true);
%!  tables = struct ("summary", summary, "modes", struct ("f", [3 4]), "statics", struct ("tip_x", 5));
%!  value = observed_value (read_observe (text), {"t [s]", "psi [rad]"}, table, tables);
%!endfunction
%!test # by hand, frames 1 s and 2 s apart
%! expected = {"max psi", 2; "min psi", -4; "max|psi|", 4; "range psi", 6; "range|psi|", 4; "first psi", 2
%!             "last psi", 0; "mean psi", (-1 - 4)/3; "mean|psi|", (3 + 4)/3; "rms psi", sqrt((10 + 16)/3)
%!             "psi at t=0", 2; "psi at t=0.5", -1; "|psi| at t=2", 2; "psi at t=3", 0; "last t", 3; "modes(2)", 7; "none", NaN
%!             "seconds.total", 3; "yes", 1; "modes.f(2)", 4; "statics.tip_x", 5};
%! for pair = expected.'
%!   assert (of (pair{1}), pair{2}, 1e-15);
%! endfor
%! assert (of ("model"), "rigid");
%! assert ([of("mean psi", [0; 5]), of("rms psi", [0; -5])], [5 5]);  # one frame
%!error <OBSERVE: history.csv has no column phi: those are t, psi> of ("max phi")
%!error <OBSERVE: t = 4 is not in the run, which is from 0 to 3 s> of ("psi at t=4")
%!error <OBSERVE: summary.json has no modus> of ("modus")
%!error <OBSERVE: summary.json has no model.name> of ("model.name")
%!error <OBSERVE: modes has no omega: it has f> of ("modes.omega")
%!error <OBSERVE: modes.f\(3\) of modes is no number> of ("modes.f(3)")
%!error <OBSERVE: modes of summary.json is no number and no text, but a 1-by-2 double> of ("modes")
%!error <OBSERVE: modes\(3\) of summary.json is no number> of ("modes(3)")
%!error <OBSERVE: list of summary.json is no number and no text, but a 1-by-1 cell> of ("list")
