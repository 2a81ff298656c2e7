## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{units}] =} section_columns (@var{along})
## Names of what the sections of rods bear, and its units: the fields of @var{along}, a cell array, a body each, of
## structs (see @code{section_forces}), which are known of some body (cellstr both).
## @end deftypefn

function [names, units] = section_columns (along)
  names = fieldnames (along{1}).';
  known = cellfun (@(name) any (cellfun (@(body) any (isfinite (body.(name))), along)), names);
  names = names(known);
  units = cellfun (@unit_of, names, "uniformoutput", false);
endfunction

function unit = unit_of (name)
  switch (name)
    case {"N", "Q"}
      unit = "N";
    case "stress"
      unit = "Pa";
    otherwise
      unit = "N m";
  endswitch
endfunction

%!test
%! body = struct ("N", [1; 2], "M", [3; 4], "stress", [NaN; NaN]);
%! [names, units] = section_columns ({body, body});
%! assert ({names, units}, {{"N", "M"}, {"N", "N m"}});
%! [names, units] = section_columns ({body, setfield(body, "stress", [1; 2])});
%! assert ({names{end}, units{end}}, {"stress", "Pa"});
