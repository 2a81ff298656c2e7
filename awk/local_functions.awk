# Functions that a generated file brings along where it calls them, since Octave's differ from Maxima's.

BEGIN {
  local_count = 0
  define_local("round_half_even", \
    "## Maxima's round: a half goes to its even neighbour.\n" \
    "function y = round_half_even (x)\n" \
    "  y = round (x) - sign (x) .* (abs (rem (x, 2)) == 0.5);\n" \
    "endfunction")
  define_local("real_power", \
    "## x^(p/q). Of a negative x it is real, as in Maxima, where p/q is a fraction with an odd denominator.\n" \
    "function y = real_power (x, p, q)\n" \
    "  y = x .^ (p ./ q);\n" \
    "  is_fraction = p == fix (p) & q == fix (q);\n" \
    "  p = merge (is_fraction, p, 1);\n" \
    "  q = merge (is_fraction, q, 2);\n" \
    "  divisor = gcd (p, q);\n" \
    "  real_root = merge (x < 0 & mod (p ./ divisor, 2) == 1, -1, 1) .* abs (x) .^ (p ./ q);\n" \
    "  y = merge (mod (q ./ divisor, 2) == 1 & imag (x) == 0, real_root, y);\n" \
    "endfunction")
  define_local("binomial", \
    "## Maxima's binomial coefficient of real numbers: a product where k or n - k is whole.\n" \
    "function y = binomial (n, k)\n" \
    "  is_other = n - k == fix (n - k) & (k != fix (k) | (n < 0 & k < n) | (n >= 0 & n - k < k));\n" \
    "  k = merge (is_other, n - k, k);\n" \
    "  is_whole = k == fix (k);\n" \
    "  y = double (k >= 0) + 0*n;\n" \
    "  for i = 1:max ([0; k(is_whole)(:)])\n" \
    "    y = merge (i <= k, y .* (n - k + i) / i, y);\n" \
    "  endfor\n" \
    "  y = merge (is_whole, y, real (exp (gammaln (n + 1) - gammaln (k + 1) - gammaln (n - k + 1))));\n" \
    "endfunction")
  define_local("log_gamma", \
    "## Maxima's log_gamma: its imaginary part falls by pi from one negative interval to the next.\n" \
    "function y = log_gamma (x)\n" \
    "  y = real (gammaln (x)) + 1i*pi * min (floor (x), 0);\n" \
    "endfunction")
  define_local("bessel_j", bessel_function("bessel_j", "besselj"))
  define_local("bessel_i", bessel_function("bessel_i", "besseli"))
  define_local("sum_of", repeated_function("sum_of", "sum", "0", "+"))
  define_local("product_of", repeated_function("product_of", "product", "1", ".*"))
}

function define_local(name, text)
{
  local_name[++local_count] = name
  local_text[local_count] = text
}

function bessel_function(name, octave)
{
  return "## Of whole order it is real below 0, too, where " octave " leaves an imaginary rounding error.\n" \
    "function y = " name " (order, x)\n" \
    "  y = " octave " (order, x);\n" \
    "  y = merge (order == fix (order) & imag (x) == 0, real (y), y);\n" \
    "endfunction"
}

function repeated_function(name, meaning, start, operator)
{
  return "## The " meaning " of term (k) for k = first, first + 1, ... up to last; " start " if there are none.\n" \
    "function y = " name " (term, first, last)\n" \
    "  y = " start ";\n" \
    "  for k = first:last\n" \
    "    y = y " operator " term (k);\n" \
    "  endfor\n" \
    "endfunction"
}

function put_local_functions(    k, list, count, line)
{
  for (k = 1; k <= local_count; k++)
    if (local_name[k] in is_called) {
      put("")
      count = split(local_text[k], list, /\n/)
      for (line = 1; line <= count; line++)
        put(list[line])
    }
}
