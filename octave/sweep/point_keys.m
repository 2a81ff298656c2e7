## -*- texinfo -*-
## @deftypefn {} {@var{keys} =} point_keys (@var{about}, @var{columns}, @var{values})
## By what the points of a sweep are known (cellstr): a hash each of the text @var{about} scene, options and program,
## and of the point's @var{values} in the @var{columns}, whose order does not matter.
## @end deftypefn

function keys = point_keys (about, columns, values)
  [columns, order] = sort (columns);
  values = values(:,order);
  keys = cell (1, rows (values));
  for k = 1:rows (values)
    keys{k} = hash ("sha256", [about "\n" point_words(columns, values(k,:))])(1:16);
  endfor
  [again, before] = first_repeated (keys);
  if (! isempty (again))
    scene_error ("points %d and %d are the same: %s", before, again, point_words (columns, values(again,:)));
  endif
endfunction

%!test
%! keys = point_keys ("x", {"a", "b"}, {1 2; 2 1});
%! assert (point_keys ("x", {"b", "a"}, {2 1; 1 2}), keys);
%! assert (isempty (intersect (point_keys ("y", {"a", "b"}, {1 2; 2 1}), keys)));
%! assert (regexp (keys, '^[0-9a-f]{16}$'), {1, 1});
%!error <points 1 and 3 are the same: a=0.1> point_keys ("", {"a"}, {0.1; 2; 0.1})
