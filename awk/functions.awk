# The functions of Maxima that Octave has: Maxima's name, Octave's, number of arguments (n: at least one). Where
# Octave's mean something else the generated file brings its own, see local_functions.awk.

BEGIN {
  define_functions("sin cos tan sec csc cot asin acos atan asec acsc acot" \
    " sinh cosh tanh sech csch coth asinh acosh atanh asech acsch acoth" \
    " exp log sqrt abs floor gamma log_gamma erf erfc erfi inverse_erf=erfinv inverse_erfc=erfcinv", 1)
  define_functions("signum=sign ceiling=ceil truncate=fix entier=floor round=round_half_even", 1)
  define_functions("atan2 mod beta binomial bessel_j bessel_y=bessely bessel_i bessel_k=besselk", 2)
  define_functions("max min", "n")

  # With nodes of their own, see calls.awk and sums.awk.
  define_functions("factorial=gamma transpose unit_step=merge", 1)
  define_functions("dot equal=merge notequal=merge", 2)
  define_functions("gamma_incomplete=gammainc gamma_incomplete_regularized=gammainc", 2)
  define_functions("beta_incomplete_regularized=betainc", 3)
  define_functions("sum=sum_of product=product_of", 4)
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
