## -*- texinfo -*-
## @deftypefn {} {[@var{columns}, @var{lists}] =} read_vary (@var{text}, @var{where})
## What "rod.length=0.2:0.1:1; solver.name=ode45,rk4" says: the names, and for each a cell array of its values (see
## @code{read_value}), of which first:step:last has the numbers as one would type them.  A range "0.2..1" is the one
## value of its list, a struct of low and high.  Errors say @var{where}.
## @end deftypefn

function [columns, lists] = read_vary (text, where)
  parts = ostrsplit (text, ";");
  parts(cellfun (@(part) isempty (strtrim (part)), parts)) = [];
  equals = cellfun (@(part) [strfind(part, "="), 0](1), parts);
  if (isempty (parts) || any (equals == 0))
    scene_error ("%s is \"%s\": it takes name=values; name=values, as in rod.length=0.2:0.1:1; rod.mu=1e9,2e9", ...
                 where, text);
  endif
  names = cellfun (@(part, k) part(1:k-1), parts, num2cell (equals), "uniformoutput", false);
  columns = read_columns (names, where);
  lists = cellfun (@(part, k, name) values_of (part(k+1:end), [where ": " name]), ...
                   parts, num2cell (equals), columns, "uniformoutput", false);
endfunction

function values = values_of (text, where)
  cells = ostrsplit ([text " "], ",");  # of "" it makes none
  values = {};
  for k = 1:numel (cells)
    steps = strsplit (cells{k}, ":");
    ends = regexp (cells{k}, '^(.+?)\.\.(.+)$', "tokens", "once");
    if (numel (steps) == 3)
      values = [values, num2cell(stepped (cellfun (@(text) number_of (text, where), steps), where))];
    elseif (! isempty (ends) && numel (cells) == 1)
      values = {range_of(number_of (ends{1}, where), number_of (ends{2}, where), where)};
    else
      values{end+1} = read_value (cells{k}, where);
    endif
  endfor
endfunction

function x = number_of (text, where)
  x = read_value (text, where);
  if (! (isnumeric (x) && isscalar (x)))
    scene_error ("%s: \"%s\" is not one number", where, strtrim (text));
  endif
endfunction

function x = stepped (steps, where)
  count = (steps(3) - steps(1))/steps(2);
  if (! (count >= 0 && count < 1e5))
    scene_error ("%s: %g:%g:%g are no steps from the first number to the last, or more than 100000", where, steps);
  endif
  x = rounded_digits (steps(1) + steps(2)*(0:floor (count*(1 + 4*eps) + 4*eps)));
endfunction

function range = range_of (low, high, where)
  if (low >= high)
    scene_error ("%s: %g..%g is no range: the first number is the smaller", where, low, high);
  endif
  range = struct ("low", low, "high", high);
endfunction

%!test
%! [columns, lists] = read_vary ("rod.length=0.2:0.1:0.4; solver.name = ode45, rk4;model.modes=0 4,7 7", "VARY");
%! assert (columns, {"rod.length", "solver.name", "model.modes"});
%! assert (lists, {{0.2, 0.3, 0.4}, {"ode45", "rk4"}, {[0 4], [7 7]}});
%! [~, lists] = read_vary ("a=0.2..1; c=-2e-1..+3;", "VARY");
%! assert (lists, {{struct("low", 0.2, "high", 1)}, {struct("low", -0.2, "high", 3)}});
%!assert (numel (nthargout (2, @read_vary, "a=0:0.1:1", ""){1}), 11)
%!assert (nthargout (2, @read_vary, "a=1:-0.5:0", ""){1}, {1, 0.5, 0})
%!error <VARY is "": it takes name=values> read_vary ("", "VARY")
%!error <VARY is "rod.length": it takes name=values> read_vary ("rod.length", "VARY")
%!error <VARY: a is blank> read_vary ("a=1,,2", "VARY")
%!error <VARY: a is blank> read_vary ("a=", "VARY")
%!error <VARY: a is "2\*pi": it takes a number> read_vary ("a=2*pi", "VARY")
%!error <VARY: a: 0:-1:1 are no steps> read_vary ("a=0:-1:1", "VARY")
%!error <VARY: a: 0:0:1 are no steps> read_vary ("a=0:0:1", "VARY")
%!error <VARY: a: 2..1 is no range> read_vary ("a=2..1", "VARY")
%!error <VARY: a: "b" is not one number> read_vary ("a=0:b:1", "VARY")
