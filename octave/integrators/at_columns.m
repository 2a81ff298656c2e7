## -*- texinfo -*-
## @deftypefn {} {@var{x} =} at_columns (@var{x}, @var{columns})
## The arrays in @var{x}, cells and structs of them to any depth, with these @var{columns} alone.
## @end deftypefn

function x = at_columns (x, columns)
  if (iscell (x))
    x = cellfun (@(part) at_columns (part, columns), x, "uniformoutput", false);
  elseif (isstruct (x))
    x = structfun (@(part) at_columns (part, columns), x, "uniformoutput", false);
  else
    x = x(:,columns);
  endif
endfunction

%!assert (at_columns (struct ("t", 1:3, "loads", {{[4 5 6; 7 8 9], zeros(0, 3)}}), [3 1]), ...
%!        struct ("t", [3 1], "loads", {{[6 4; 9 7], zeros(0, 2)}}))
