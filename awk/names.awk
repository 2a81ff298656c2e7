# Names: Maxima's may hold %, ? and escaped characters; Octave's may not, nor may they hide a function that the
# generated file calls. Distinct Maxima names always get distinct Octave names.

BEGIN {
  maxima_name = "([A-Za-z_%?]|\\\\.)([A-Za-z0-9_%?]|\\\\.)*"

  # Keywords, and names with a meaning of their own in a function.
  reserve("__FILE__ __LINE__ break case catch classdef continue do else elseif end end_try_catch" \
    " end_unwind_protect endarguments endclassdef endenumeration endevents endfor endfunction endif endmethods" \
    " endparfor endproperties endspmd endswitch endwhile enumeration events for function global if methods" \
    " otherwise parfor persistent properties return spmd switch try unwind_protect unwind_protect_cleanup until" \
    " while arguments varargin varargout nargin nargout ans")

  # What any generated file may call, whatever functions its body names.
  reserve("Inf check_sizes columns exp false merge pi print_usage real_power rows size size_equal sum true zeros")
}

function reserve(words,    list, k, count)
{
  count = split(words, list, / /)
  for (k = 1; k <= count; k++)
    taken[list[k]] = 1
}

# The functions of the table are reserved only where they are called: beta is a fine name for an angle.
function reserve_called_functions(    k)
{
  for (k = 1; k <= token_count; k++)
    if (token[k] == "!")
      taken["gamma"] = 1
    else if (token[k] in function_octave && token[k + 1] == "(")
      taken[function_octave[token[k]]] = 1
}

# A new Octave name that resembles the Maxima name.
function octave_name(name)
{
  gsub(/\\/, "", name)
  gsub(/[^A-Za-z0-9_]/, "_", name)
  if (name ~ /^[_0-9]/)
    name = "v" name
  while (name in taken)
    name = name "_"
  taken[name] = 1
  return name
}
