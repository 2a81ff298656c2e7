# Special functions, sums and products.

# Of arguments where values are real, and not 0, which makes a number of a matrix in Maxima.
function special(depth,    kind)
{
  kind = random(8)
  if (kind == 1)
    return "bessel_j(" word("0 1 2 k -1 -k") "," word("a b 2*a k/3") ")+bessel_i(" word("0 1 k -2") "," bounded(0) ")"
  if (kind == 2)
    return word("bessel_j bessel_y bessel_i bessel_k") "(" word("0 1 k 1/2 -3/2 k+1/3") "," positive(0) ")"
  if (kind == 3)
    return word("erfi inverse_erf") "(" bounded(depth) ")*inverse_erfc(1+" bounded(0) ")"
  if (kind == 4)
    return word("gamma_incomplete gamma_incomplete_regularized") "(" word("1/2 1 k k+1/2 7/3") "," positive(0) ")"
  if (kind == 5)
    return "beta_incomplete_regularized(" word("1/2 2 k") "," word("k 3/2 k+1/3") ",1/" positive(0) ")"
  if (kind == 6)
    return "1/3+binomial(" word("k+1/2 5/2 -3/2 a") "," word("1/3 7/4 k -k 2 k+1/3") ")"
  if (kind == 7)
    return "1/3+binomial(" word("-3,-k-3 -3,-k k,k+2 -k-1,-k-1 1/2,k-1/2 5/2,k+1/2") ")"
  return "(1/2+unit_step(" exact() "))*" leaf()
}

# Finite sums and products, at most one in another. Their index stands beside the term. Where Maxima looks for common
# subexpressions it finds some with the index in them, outside of which they have no value.
function repeated(depth,    text)
{
  if (optimized || nested == 2)
    return leaf()
  nested++
  text = repeated_term(depth, nested == 1 ? "i" : "j") "," word("1,3 1,k 1,k+1 k,4 k,k k-1,2*k")
  nested--
  return "(" text "))"
}

function repeated_term(depth, i)
{
  if (random(2) == 1)
    return "'sum((" number(depth) ")*" word(i " " i "^2 (-1)^" i " 1/(1+" i ") u[1+mod(" i ",3)] " i "!") "," i
  return "'product((" bounded(depth) ")/" i "!+" word("2^" i " " i "^2+1") "," i
}
