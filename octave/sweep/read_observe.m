## -*- texinfo -*-
## @deftypefn {} {@var{observed} =} read_observe (@var{text})
## What "max|tip_y|, last psi, tip_x at t=0.5, estimated_error_m" asks for, with commas between:
##
## @table @code
## @item max tip_y
## of a column of history.csv, by its name without unit, max, min, mean, range (largest less smallest), rms, first or
## last; mean and rms are those over time
## @item tip_x at t=0.5
## a column at a time (s), between two frames by a straight line
## @item |tip_y|
## in the place of a column is its absolute value
## @item estimated_error_m, seconds.integration, modes(2)
## a number or a text of summary.json
## @item modes.f(1), statics.tip_y
## a number of what @code{natural_modes} or @code{statics} find (see @code{verb_tables}), which each point then runs,
## too
## @item truth.error_m
## what @code{true_figures} says of the run's error
## @end table
##
## @var{observed} is a struct array of text, part (as "max", "at", "summary", "modes", "statics" or "truth"),
## absolute, name, time and index (0 where none is stated).
## @end deftypefn

function observed = read_observe (text)
  items = strtrim (ostrsplit ([text " "], ","));
  observed = cellfun (@read_item, items, "uniformoutput", false);
  observed = [observed{:}];
  again = first_repeated ({observed.text});
  if (! isempty (again))
    scene_error ("OBSERVE: %s stands there twice", items{again});
  endif
endfunction

function item = read_item (text)
  column = '([A-Za-z][\w-]*|\|\s*[A-Za-z][\w-]*\s*\|)';
  of_column = regexp (text, ['^(max|min|mean|range|rms|first|last)(?:\s+|(?=\|))' column '$'], "tokens", "once");
  at_time = regexp (text, ['^' column '\s+at\s+t\s*=\s*([-+.\deE]+)$'], "tokens", "once");
  of_summary = regexp (text, '^([A-Za-z]\w*(?:\.[A-Za-z]\w*)*)(\([1-9]\d*\)|)$', "tokens", "once");
  item = struct ("text", text, "part", "summary", "absolute", false, "name", "", "time", [], "index", 0);
  if (! isempty (of_column))
    item.part = of_column{1};
    item = of_name (item, of_column{2});
  elseif (! isempty (at_time) && isfinite (str2double (at_time{2})))
    item.part = "at";
    item.time = str2double (at_time{2});
    item = of_name (item, at_time{1});
  elseif (! isempty (of_summary))
    [item.part, item.name] = part_of (of_summary{1});
    item.index = str2double (["0" of_summary{2}(2:end-1)]);
  else
    scene_error (["OBSERVE: \"%s\" is not understood: it takes max, min, mean, range, rms, first or last of a" ...
                  " column, as max|tip_y|, a column at a time, as psi at t=0.5, a name of summary.json, or" ...
                  " modes.f(1), statics.tip_y or truth.error_m"], text);
  endif
endfunction

function [part, name] = part_of (name)
  part = "summary";
  verb = regexp (name, '^(modes|statics|truth)\.(.*)$', "tokens", "once");
  if (! isempty (verb))
    [part, name] = verb{:};
  endif
endfunction

function item = of_name (item, column)
  item.absolute = column(1) == "|";
  item.name = strtrim (strrep (column, "|", ""));
endfunction

%!function item = one (text)
%!  item = rmfield (read_observe (text), "text");
%!endfunction
%!function item = of (part, absolute, name, time, index)
%!  item = struct ("part", part, "absolute", absolute, "name", name, "time", time, "index", index);
%!endfunction
%!assert (one ("max|tip_y|"), of ("max", true, "tip_y", [], 0))
%!assert (one (" last  V1_-1 "), of ("last", false, "V1_-1", [], 0))
%!assert (one ("mean | psi |"), of ("mean", true, "psi", [], 0))
%!assert (one ("|psi| at t=0.5"), of ("at", true, "psi", 0.5, 0))
%!assert (one ("psi at t = 1e-3"), of ("at", false, "psi", 1e-3, 0))
%!assert (one ("estimated_error_m"), of ("summary", false, "estimated_error_m", [], 0))
%!assert (one ("modes(2)"), of ("summary", false, "modes", [], 2))
%!assert (one ("seconds.total"), of ("summary", false, "seconds.total", [], 0))
%!assert (one ("modes.f(2)"), of ("modes", false, "f", [], 2))
%!assert (one ("truth.error_m"), of ("truth", false, "error_m", [], 0))
%!assert (one ("statics.reaction_x"), of ("statics", false, "reaction_x", [], 0))
%!assert ({read_observe("max psi, model").text}, {"max psi", "model"})
%!error <OBSERVE: last psi stands there twice> read_observe ("last psi, model, last psi")
%!test
%! for bad = {"", "maximum psi", "max|psi", "|psi|", "psi at t=soon", "max psi;", "system('ls')", "max 2*psi", ...
%!            "psi at 0.5", "max psi at t=1"}
%!   fail ("read_observe (bad{1})", "OBSERVE: \".*\" is not understood: it takes max");
%! endfor
