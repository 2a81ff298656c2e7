## -*- texinfo -*-
## @deftypefn {} {@var{reduced} =} project_arrays (@var{arrays}, @var{basis})
## The @var{arrays} of a rod (names that end with _matrix: n-by-n; with _vector, _1 or _2: n-by-1; scalars) for
## V = @var{basis}*q, with r columns: r-by-r and r-by-1.
## @end deftypefn

function reduced = project_arrays (arrays, basis)
  for [value, name] = arrays
    if (regexp (name, '_matrix$'))
      value = basis.'*value*basis;
    elseif (regexp (name, '_(vector|1|2)$'))
      value = basis.'*value;
    endif
    reduced.(name) = value;
  endfor
endfunction

%!test
%! arrays = struct ("mass_matrix", [2 1; 1 3], "coupling_vector", [1; 2], "moment_of_inertia", 5);
%! reduced = project_arrays (arrays, [1; 1]);
%! assert ([reduced.mass_matrix, reduced.coupling_vector, reduced.moment_of_inertia], [7 3 5]);
