## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{places}] =} path_places (@var{shape})
## Places (m) of mid-span and tip along a path whose shapes (see @code{load_path}) are given: @var{names} as columns of
## history.csv have them, and the places, a row a name, a column a point.
## @end deftypefn

function [names, places] = path_places (shape)
  names = {};
  places = [];
  for k = 1:numel (shape)
    behind = sprintf ("_%d", k)(1:end*(numel (shape) > 1));
    last = rows (shape{k});
    for where = {"mid", "tip"; (last + 1)/2, last}
      names = [names, strcat(where{1}, {"_x", "_y", "_z"}(1:columns (shape{k})), behind)];
      places = [places; reshape(shape{k}(where{2},:,:), columns (shape{k}), [])];
    endfor
  endfor
endfunction

%!test # two bodies of three places, at three points of a path
%! body = @(x) x + cat (3, [0 0; 1 2; 3 4], [0 0; 5 6; 7 8], [0 0; 9 1; 2 3]);
%! [names, places] = path_places ({body(0), body(10)});
%! assert (names, {"mid_x_1", "mid_y_1", "tip_x_1", "tip_y_1", "mid_x_2", "mid_y_2", "tip_x_2", "tip_y_2"});
%! assert (places, [1 5 9; 2 6 1; 3 7 2; 4 8 3; 11 15 19; 12 16 11; 13 17 12; 14 18 13]);
%! assert (path_places ({rand(3, 3, 2)}), {"mid_x", "mid_y", "mid_z", "tip_x", "tip_y", "tip_z"});
