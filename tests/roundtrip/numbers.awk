# Random expressions for numbers. Arguments of functions are kept in the domain, and away from jumps, by construction:
# bounded lies in [-1/2, 1/2], positive above 1, and exact is free of rounding errors on both sides.
# With `arrays' the array arguments may appear.
# max, min, abs and atan2 get no conditionals: Maxima asks for signs, and the sign of some it cannot find without end.

function number(depth,    kind)
{
  if (depth == 0)
    return leaf()
  kind = depth == 3 ? random(22) : random(21)
  if (kind <= 6)
    return "(" number(depth - 1) word("+ - * + * **2+") number(depth - 1) ")"
  if (kind == 7)
    return number(depth - 1) word("+ - *") "(-" leaf() ")"
  if (kind == 8)
    return word("- +") number(depth - 1)
  if (kind == 9)
    return number(depth - 1) "/" positive(depth - 1)
  if (kind <= 12)
    return power(depth - 1)
  if (kind <= 15)
    return call(depth - 1)
  if (kind <= 17)
    return conditional(depth - 1)
  if (kind == 18)
    return rounded()
  if (kind == 19)
    return repeated(depth - 1)
  if (kind == 20)
    return special(depth - 1)
  return kind == 21 ? scalar_of_matrices(depth - 1) : long_quotient() "*" number(1)
}

function leaf(    kind)
{
  kind = random(8)
  if (kind <= 3 && arrays)
    return word("x y")
  if (kind <= 5)
    return word("a b pi merge c\\-d c%d k u[1] u[k] u[k+1] R[1,2] R[2,k] R[2][k] R[k][3]")
  if (kind == 6)
    return word("%pi %e 1.5 .25 2.5e-3 2.5E-5 1.2345b-1 7.5b0 3.0e0")
  return kind == 7 ? random(9) : "(" word("- +") random(9) "/" (1 + random(9)) ")"
}

# Not inside powers, where Maxima would multiply the integers out.
function long_quotient(    length_wanted)
{
  length_wanted = word("45 120 400")
  return "(" digits(length_wanted) "/" digits(length_wanted + random(3) - 2) ")"
}

function bounded(depth,    e)
{
  e = number(depth)
  return "(" e ")/(1+(" e ")^2)"
}

function positive(depth)
{
  return "(" (1 + random(2)) "+(" number(depth) ")^2)"
}

function power(depth,    kind)
{
  kind = random(14)
  if (kind == 1) return "(" number(depth) ")^" word("2 3 k")
  if (kind == 2) return positive(depth) "^-" word("1 2 k (1/2) 1.5")
  if (kind == 3) return positive(depth) "^(" bounded(depth) ")"
  if (kind == 4) return word("2 3 %e %pi") "^-(" bounded(depth) ")"
  if (kind == 5) return "-" leaf() "^2"
  if (kind == 6) return "(-" leaf() ")^" word("2 3")
  if (kind == 7) return "%e^-" leaf() "^2"
  if (kind == 8) return word("2 3") "^" word("2 k") "^(" bounded(depth) ")"
  if (kind == 9) return "(" positive(depth) "^" word("2 3") ")^" word("2 (1/3) -1.5")
  if (kind <= 12)
    return "(" exact() ")^(" word("1/3 2/3 5/3 3/5 2/6 k/3 2*k/7 k+1/3 k/3+1/5 1/(2*k+1)") ")"
  if (kind == 13)
    return "(-" positive(depth) ")^(" word("-1/3 -2/3 -k/5 1/3 4/3 k/7 k-1/3") ")"
  if (kind == 10) return positive(depth) "^-k^" word("2 (1/2)") "*" leaf()
  return word("2 k") "^-a*" leaf()
}

function call(depth,    kind)
{
  kind = random(9)
  if (kind <= 2)
    return word("sin cos atan sinh cosh tanh tan asin acos atanh asinh erf erfc exp sech") "(" bounded(depth) ")"
  if (kind == 3)
    return word("log sqrt asec acsc acosh acoth acsch acot csch coth") "(" positive(0) ")"
  if (kind == 4)
    return word("gamma log_gamma sec csc cot") "(1+1/" positive(depth) ")"
  if (kind == 5)
    return word("max min") "(" exact() "," leaf() "*" leaf() "," leaf() ")" word("+ -") "abs(" exact() ")"
  if (kind == 6)
    return "atan2(" leaf() "*" leaf() "," positive(0) ")"
  if (kind == 7)
    return word("k! (k+2)! 3! -k!^2 2^k! binomial(k+3,2) binomial(5,k) beta(k,2) asech(1/(1+k))")
  return kind == 8 ? "(" bounded(depth) ")!" : "factorial(" bounded(depth) ")"
}
