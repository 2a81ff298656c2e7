## -*- texinfo -*-
## @deftypefn {} {@var{text} =} value_text (@var{value})
## A field's @var{value} as a person writes it: a text as it is, a function by its expression with the numbers that
## have names there, numbers with up to six digits, true and false, "none" for what is empty, and what a cell array
## holds one after the other.
## @end deftypefn

function text = value_text (value)
  if (is_function_handle (value))
    text = [func2str(value), named_numbers(value)];
  elseif (isempty (value))
    text = "none";
  elseif (ischar (value))
    text = value;
  elseif (iscell (value))
    text = strjoin (cellfun (@value_text, value(:).', "UniformOutput", false), ", ");
  elseif (isnumeric (value) || islogical (value))
    text = mat2str (value, 6);
  else
    text = class (value);
  endif
endfunction

function text = named_numbers (f)
  text = "";
  known = functions (f);
  if (isfield (known, "workspace"))
    for [value, name] = known.workspace{1}
      if (isnumeric (value) && isrow (value) && numel (value) <= 4)
        text = sprintf ("%s, %s = %s", text, name, mat2str (value, 6));
      endif
    endfor
    text = regexprep (text, '^,', " where");
  endif
endfunction

%!test
%! [moment, pulse, table] = deal (0.25, [0 1.5], ones (9));
%! assert (value_text (@(t) moment + zeros (size (t))), "@(t) moment + zeros (size (t)) where moment = 0.25");
%! assert (value_text (@(t) interp1 (pulse, table, t)), "@(t) interp1 (pulse, table, t) where pulse = [0 1.5]");
%! assert (value_text (@sin), "sin");
%!assert (value_text (@(t) 300*t), "@(t) 300 * t")
%!assert (value_text ([]), "none")
%!assert (value_text ([0.1 7]), "[0.1 7]")
%!assert (value_text (true), "true")
%!assert (value_text ({[0 1], "a"}), "[0 1], a")
