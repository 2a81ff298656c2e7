## -*- texinfo -*-
## @deftypefn {} {@var{points} =} points_of_coordinates (@var{mechanism}, @var{stations})
## How far changes of the coordinates of a @var{mechanism} move points of its bodies (m), as its bodies are made: a
## sparse m-by-n matrix, of each body x, y, its angle at the tip's distance and the displacements of so many stations
## (11) along and across it. Sines and corrections for the ends, each of them large, may leave every point where it is.
## @end deftypefn

function points = points_of_coordinates (mechanism, stations = 11)
  row = column = value = {};
  count = 0;
  for group = mechanism.groups
    model = group.model;
    [along, across] = functions_at (model.base, linspace (0, model.length, stations));
    [i, j, metres] = find (blkdiag ([along; across], model.length, 1, 1));
    for index = group.index
      row{end+1} = count + i;
      column{end+1} = index(j)(:);
      value{end+1} = metres;
      count += 2*stations + 3;
    endfor
  endfor
  points = sparse (vertcat (row{:}), vertcat (column{:}), vertcat (value{:}), count, mechanism.n);
endfunction

%!test # a rigid body's angle, its place, and a bending mode, which is 1 m in the middle
%! [system, ~] = sample_mechanism ([0 1]);
%! points = points_of_coordinates (system.mechanism);
%! index = index_of (system.mechanism, 2);
%! mode = index(1); phi = index(end-2);
%! assert (full (max (abs (points(:,mode)))), 1, 1e-12);
%! assert (full (max (points(:,phi))), system.mechanism.models{2}.length);
%! assert (full (sum (abs (points(:,index(end)) > 0))), 1);
