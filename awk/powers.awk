# Powers. Maxima has the real root of a negative number where the exponent is a fraction with an odd denominator,
# Octave a complex one. So an exponent that may be such a fraction goes to real_power (local_functions.awk) as two
# whole numbers; an even denominator, or a float, stays as it is in both.

function power_node(base, exponent)
{
  if (node_operator[base] == "name" && node_text[base] == "exp(1)")
    return call_node("exp", exponent)
  if (is_never_negative(base) || !may_be_odd_root(exponent))
    return binary_node("^", base, exponent)
  return with_argument(with_argument(call_node("real_power", base), top[exponent]), bottom[exponent])
}

# M^^k, the product of k matrices M; k < 0: of their inverses.
function matrix_power_node(base, exponent,    part)
{
  must_be_number(base, "^^")
  must_be_number(exponent, "^^")
  if (node_shape[exponent] != "scalar")
    fail("`^^' wants a scalar exponent, not " node_shape[exponent])
  if (node_shape[base] == "scalar")
    return power_node(base, exponent)
  if (split(node_shape[base], part, /-by-/) != 2 || part[1] != part[2])
    fail("`^^' wants a square matrix, not " node_shape[base])
  split_fraction(exponent)
  if (bottom[exponent] != one || has_float(exponent))
    fail("`^^' wants a whole exponent")
  exponent = binary_node("^^", base, exponent)
  node_shape[exponent] = node_shape[base]
  return exponent
}

function may_be_odd_root(exponent,    p, q)
{
  split_fraction(exponent)
  if (bottom[exponent] == one || has_float(exponent))
    return 0
  p = integer_text(top[exponent])
  q = integer_text(bottom[exponent])
  if (q ~ /^(2|4|8|16|32|64)$/ || (q ~ /[02468]$/ && p ~ /[13579]$/))
    return 0
  if (length(p) > 15 || length(q) > 15)
    fail("a power is a root or not: that cannot be decided of an exponent with more than 15 digits")
  return 1
}

# The digits of a number or its negative; "" if it is something else.
function integer_text(id)
{
  if (node_operator[id] == "negative")
    id = child[id, 1]
  return node_operator[id] == "number" ? node_text[id] : ""
}

function is_never_negative(id)
{
  if (node_operator[id] == "^")
    return integer_text(child[id, 2]) ~ /^[0-9]*[02468]$/ || is_never_negative(child[id, 1])
  if (node_operator[id] ~ /^[+*\/]$/)
    return is_never_negative(child[id, 1]) && is_never_negative(child[id, 2])
  return node_operator[id] == "number" || (node_operator[id] == "name" && node_text[id] ~ /^(pi|Inf)$/) \
    || (node_operator[id] == "call" && node_text[id] ~ /^(exp|abs|cosh)$/)
}
