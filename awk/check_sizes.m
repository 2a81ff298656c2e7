## -*- texinfo -*-
## @deftypefn {} {} check_sizes (@var{caller}, @var{checked})
## Name the first argument of a generated function, the @var{caller}, that has a wrong size.  @var{checked} has a row an
## argument: its name, its value and the size that it must have, or [] where it is an array: arrays are scalars or of
## equal sizes.
## @end deftypefn

function check_sizes (caller, checked)
  written = @(sizes) sprintf ("-by-%d", sizes)(5:end);
  common = [];
  for k = 1:rows (checked)
    [name, value, expected] = checked{k,:};
    if (isempty (expected) && isscalar (value))
      continue;
    elseif (isempty (expected))
      if (isempty (common))
        common = size (value);
      endif
      expected = common;
    endif
    if (! isequal (size (value), expected))
      error ("%s: %s must be %s, not %s", caller, name, written (expected), written (size (value)));
    endif
  endfor
endfunction
