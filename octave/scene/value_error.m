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

## The first row whose pattern the kind has says what it takes.
function good = is_of_kind (kind, value)
  persistent table = {
    '^text$',               @(x) ischar (x) && rows (x) <= 1
    '^true or false$',      @(x) isscalar (x) && (islogical (x) || (is_number (x) && any (x == [0 1])))
    '^struct array',        @(x) iscell (x) || isstruct (x)
    '^vector of two coordinates', @(x) is_vector_of (x, 2)
    '^three numbers',       @(x) is_vector_of (x, 3)
    '^vector',              @(x) is_real (x) && (isvector (x) || isempty (x)) && all (isfinite (x(:)))
    'at least 3 each$',     @(x) is_pair (x, 3, 1000) && all (x(:) == fix (x(:)))
    '\[N1 N2\]',            @(x) is_pair (x, 0, 1000) && all (x(:) == fix (x(:)))
    '\[W H\]',              @(x) is_pair (x, 320, 8192) && all (mod (x(:), 2) == 0)
    '^number from 0 to 1$', @(x) is_number (x) && x >= 0 && x <= 1
    '^whole number from 1 to 50', @(x) is_number (x) && any (x == 1:50)
    'positive number',      @(x) is_number (x) && x > 0
    'nonnegative number',   @(x) is_number (x) && x >= 0
    'number',               @(x) is_number (x)
    '.',                    @(x) false
  };
  choices = [regexp(kind, '"(\w+)"', "tokens"){:}];
  if (strncmp (kind, "two of", 6))
    good = iscellstr (value) && numel (value) == 2 && all (ismember (value, choices));
  elseif (ischar (value) && ! isempty (choices))
    good = any (strcmp (value, choices));
  elseif (is_function_handle (value))
    good = ! isempty (strfind (kind, "function"));
  else
    row = find (! cellfun (@(pattern) isempty (regexp (kind, pattern, "once")), table(:,1)), 1);
    good = table{row,2}(value);
  endif
endfunction

function yes = is_real (value)
  yes = isnumeric (value) && isreal (value);
endfunction

function yes = is_number (value)
  yes = is_real (value) && isscalar (value) && isfinite (value);
endfunction

function yes = is_vector_of (value, count)
  yes = is_real (value) && numel (value) == count && all (isfinite (value(:)));
endfunction

function yes = is_pair (value, least, most)
  yes = is_real (value) && numel (value) == 2 && all (value(:) >= least & value(:) <= most);
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
%!test # each kind to its ends, and beyond them
%! taken = {"number from 0 to 1", {0, 1}, {-0.1, 1.1, NaN, [0 1]}
%!          "positive number", {realmin}, {0}
%!          "nonnegative number", {0, 2}, {-realmin, NaN}
%!          "true or false", {0, true}, {2, [true false], "yes"}
%!          "struct array", {{}, struct()}, {3}
%!          "text", {"", "word"}, {["a"; "b"], 3}
%!          "vector of times in s", {[], 3, 1:9}, {eye(2), [1 Inf], 1i}
%!          "two numbers of modes [N1 N2]", {[0 1000]}, {[-1 3], [0 1001], [1 2 3]}
%!          "even numbers of pixels [W H]", {[320 8192], [322 324]}, {[318 400], [400 8194]}
%!          "\"auto\" or two numbers [N1 N2], at least 3 each", {[3 1000], "auto"}, {[2 3], [3 1001], [3 3.5], "all"}
%!          "vector of two coordinates of the chart", {[0.1 -2], [3; 4]}, {[1 2 3], [1 NaN], [1i 2], []}
%!          "three numbers or function of t in N", {[1 2 3], @sin}, {[1 2], [1 2 Inf], []}
%!          "two of \"free\" and \"hinge\"", {{"free", "free"}, {"hinge"; "free"}}, ...
%!            {"free", {"free"}, {"free", "glue"}, {1, 2}}};
%! for row = taken.'
%!   cellfun (@(value) assert (value_error (row{1}, value), "", row{1}), row{2});
%!   cellfun (@(value) assert (! isempty (value_error (row{1}, value)), row{1}), row{3});
%! endfor
%!assert (value_error ("number", 1:4), "1   2   3   4")
%!assert (value_error ("number", 1:5), "a 1-by-5 double")
