## -*- texinfo -*-
## @deftypefn {} {@var{value} =} field_or (@var{given}, @var{name}, @var{value})
## The field with this @var{name} of the struct @var{given}, or the @var{value} where it has none.
## @end deftypefn

function value = field_or (given, name, value)
  if (isfield (given, name))
    value = given.(name);
  endif
endfunction

%!assert (field_or (struct ("a", 1), "a", 2), 1)
%!assert (field_or (struct ("a", 1), "b", 2), 2)
