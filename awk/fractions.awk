# Exponents as fractions.
#
#   top[id], bottom[id]     the expression id as a fraction; bottom[id] is `one' where it is none
#   definition[id]          value of the temporary that the node id names
#   long_integer[id]        digits of an integer that numbers.awk has shortened

BEGIN {
  one = new_node("number", "1", "scalar", 0, 0)
}

function has_float(id,    k)
{
  if (id in definition)
    return has_float(definition[id])
  if (node_operator[id] == "number")
    return !(id in long_integer) && !is_integer(node_text[id])
  for (k = 1; k <= child_count[id]; k++)
    if (has_float(child[id, k]))
      return 1
  return 0
}

# Set top[id] and bottom[id].
function split_fraction(id,    operator, k)
{
  if (id in top)
    return
  take_fraction(id, id in long_integer ? new_node("number", long_integer[id], "scalar", 0, 0) : id, one)
  if (id in definition) {
    split_fraction(definition[id])
    if (bottom[definition[id]] != one)
      take_fraction(id, top[definition[id]], bottom[definition[id]])
  }
  operator = node_operator[id]
  if (operator !~ /^(negative|if|[-+*\/^])$/)
    return
  for (k = operator == "if" ? 2 : 1; k <= child_count[id]; k++)
    split_fraction(child[id, k])
  if (operator == "negative")
    split_negative(id, child[id, 1])
  else if (operator == "^")
    split_power(id, child[id, 1], child[id, 2])
  else
    split_operation(id, operator, child[id, child_count[id] - 1], child[id, child_count[id]])
}

function split_negative(id, operand)
{
  if (bottom[operand] != one)
    take_fraction(id, unary_node("negative", top[operand]), bottom[operand])
}

function split_power(id, base, exponent)
{
  if (node_operator[exponent] == "negative")
    take_fraction(id, power_of(bottom[base], child[exponent, 1]), power_of(top[base], child[exponent, 1]))
  else if (bottom[base] != one)
    take_fraction(id, power_of(top[base], exponent), power_of(bottom[base], exponent))
}

# Also of the branches of `if'.
function split_operation(id, operator, left, right)
{
  if (operator == "*")
    take_fraction(id, times(top[left], top[right]), times(bottom[left], bottom[right]))
  else if (operator == "/")
    take_fraction(id, times(top[left], bottom[right]), times(bottom[left], top[right]))
  else if (bottom[left] != one || bottom[right] != one)
    take_fraction(id, combined(id, times(top[left], bottom[right]), times(top[right], bottom[left])), \
      times(bottom[left], bottom[right]))
}

function take_fraction(id, numerator, denominator)
{
  top[id] = numerator
  bottom[id] = denominator
}

function combined(id, left, right)
{
  return node_operator[id] == "if" ? if_node(child[id, 1], left, right) : binary_node(node_operator[id], left, right)
}

function times(left, right)
{
  return left == one ? right : right == one ? left : binary_node("*", left, right)
}

function power_of(base, exponent)
{
  return base == one ? one : binary_node("^", base, exponent)
}
