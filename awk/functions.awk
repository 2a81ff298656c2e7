# The functions of Maxima that Octave has with the same meaning: Maxima's name, Octave's, number of arguments (n: at
# least one). Maxima's round goes to the even neighbour, Octave's does not, so the generated file brings its own.

BEGIN {
  define_functions("sin cos tan sec csc cot asin acos atan asec acsc acot" \
    " sinh cosh tanh sech csch coth asinh acosh atanh asech acsch acoth" \
    " exp log sqrt abs floor gamma erf erfc", 1)
  define_functions("signum=sign ceiling=ceil truncate=fix entier=floor round=round_half_even log_gamma=gammaln", 1)
  define_functions("atan2 mod beta binomial=bincoeff", 2)
  define_functions("max min", "n")

  # With nodes of their own, see atoms.awk.
  define_functions("factorial=gamma transpose", 1)
  define_functions("dot", 2)
}

function define_functions(words, arity,    list, pair, k, count)
{
  count = split(words, list, / /)
  for (k = 1; k <= count; k++) {
    if (split(list[k], pair, /=/) == 1)
      pair[2] = pair[1]
    function_octave[pair[1]] = pair[2]
    function_arity[pair[1]] = arity
    is_octave_function[pair[2]] = 1
  }
}
