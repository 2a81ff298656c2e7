## -*- texinfo -*-
## @deftypefn {} {@var{message} =} value_error (@var{kind}, @var{value})
## Empty if @var{value} is of the @var{kind} that a scene's field takes (see @code{scene_fields}), and otherwise what
## it is: "-1", "a 1-by-3 double", "\"fast\"".
## @end deftypefn

function message = value_error (kind, value)
  message = "";
  if (! is_of_kind (kind, value))
    message = describe (value);
  endif
endfunction

function good = is_of_kind (kind, value)
  choices = regexp (kind, '"(\w+)"', "tokens");
  choices = [choices{:}];
  number = isnumeric (value) && isreal (value) && isscalar (value) && isfinite (value);
  if (ischar (value) && ! isempty (choices))
    good = any (strcmp (value, choices));
  elseif (strcmp (kind, "text"))
    good = ischar (value) && rows (value) <= 1;
  elseif (strcmp (kind, "true or false"))
    good = isscalar (value) && (islogical (value) || (number && any (value == [0 1])));
  elseif (is_function_handle (value))
    good = ! isempty (strfind (kind, "function"));
  elseif (strncmp (kind, "struct array", 12))
    good = iscell (value) || isstruct (value);
  elseif (strncmp (kind, "vector", 6))
    good = isnumeric (value) && isreal (value) && (isvector (value) || isempty (value)) && all (isfinite (value(:)));
  elseif (! isempty (strfind (kind, "[N1 N2]")))
    good = isnumeric (value) && isreal (value) && numel (value) == 2 ...
           && all (value(:) >= 0 & value(:) == fix (value(:))) && all (value(:) <= 1000);
  elseif (! isempty (strfind (kind, "[W H]")))
    good = isnumeric (value) && isreal (value) && numel (value) == 2 && all (value(:) >= 320 & value(:) <= 8192) ...
           && all (mod (value(:), 2) == 0);
  elseif (strcmp (kind, "number from 0 to 1"))
    good = number && value >= 0 && value <= 1;
  elseif (! isempty (strfind (kind, "positive number")))
    good = number && value > 0;
  elseif (! isempty (strfind (kind, "nonnegative number")))
    good = number && value >= 0;
  else
    good = number && ! isempty (strfind (kind, "number"));
  endif
endfunction

function text = describe (value)
  if (ischar (value) && rows (value) == 1)
    text = sprintf ("\"%s\"", value);
  elseif ((isnumeric (value) || islogical (value)) && isvector (value) && numel (value) <= 4)
    text = strtrim (disp (value(:).'));
  else
    text = sprintf ("a %s %s", strjoin (arrayfun (@num2str, size (value), "uniformoutput", false), "-by-"), ...
                    class (value));
  endif
endfunction

%!assert (value_error ("positive number in m", 2), "")
%!assert (value_error ("positive number in m", -1), "-1")
%!assert (value_error ("positive number in m", NaN), "NaN")
%!assert (value_error ("positive number in m", 1i), "0 + 1i")
%!assert (value_error ("positive number in m", [1 2]), "1   2")
%!assert (value_error ("\"pixel\" or positive number in m", "pixel"), "")
%!assert (value_error ("\"pixel\" or positive number in m", "pixels"), "\"pixels\"")
%!assert (value_error ("\"auto\" or two numbers of modes [N1 N2]", [0 7]), "")
%!assert (value_error ("\"auto\" or two numbers of modes [N1 N2]", [0.5 7]), "0.5000   7.0000")
%!assert (value_error ("number or function of t in N m", @sin), "")
%!assert (value_error ("two even numbers of pixels from 320 to 8192 [W H]", [640 360]), "")
%!assert (value_error ("two even numbers of pixels from 320 to 8192 [W H]", [640 361]), "640   361")
%!assert (value_error ("number in rad", @sin), "a 1-by-1 function_handle")
%!assert (value_error ("vector of times in s", {}), "a 0-by-0 cell")
%!assert (value_error ("true or false", 1), "")
