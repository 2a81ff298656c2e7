## -*- texinfo -*-
## @deftypefn {} {@var{points} =} string_points (@var{nodes}, @var{n})
## A string of @var{n} straight elements through the places that @var{nodes} (a struct of x and y, m, rows even along
## the unstretched string) has at their ends, as 21 points.
## @end deftypefn

function points = string_points (nodes, n)
  for axis = {"x", "y"}
    ends = interp1 (linspace (0, 1, rows (nodes.x)), nodes.(axis{1}), linspace (0, 1, n + 1).');
    points.(axis{1}) = interp1 (linspace (0, 1, n + 1), ends, linspace (0, 1, 21).');
  endfor
endfunction

%!assert (string_points (struct ("x", [0 0; 1 2; 4 4], "y", zeros (3, 2)), 1).x(11,:), [2 2], 1e-12)
