# Calls: elementwise functions of the table in functions.awk, and the few with nodes of their own.

# Maxima prints 'round(x) where it could not evaluate round: the call is meant.
function parse_noun()
{
  if (!(token[position] in function_arity))
    fail("the noun '" shortened(token[position]) " cannot be translated")
  return parse_call(advance())
}

# The name has been read.
function parse_call(name,    id)
{
  expect("(")
  if (name == "matrix")
    return parse_matrix()
  if (!(name in function_arity))
    fail("the function " shortened(name) " cannot be translated")
  id = new_node("arguments", "", "", 0, 0)
  parse_sequence(id, ")")
  if (function_arity[name] == "n")
    return fold(function_octave[name], id)
  if (child_count[id] != function_arity[name])
    fail("the function " name " cannot have " child_count[id] " arguments")
  if (function_arity[name] == 2)
    return name == "dot" ? dot_node(child[id, 1], child[id, 2]) \
      : call_node(function_octave[name], child[id, 1], child[id, 2])
  if (name == "factorial")
    return factorial_node(child[id, 1])
  return name == "transpose" ? transpose_node(child[id, 1]) : call_node(function_octave[name], child[id, 1], 0)
}

# Octave's max and min take two.
function fold(name, id,    k, value)
{
  must_be_number(child[id, 1], name)
  value = child[id, 1]
  for (k = 2; k <= child_count[id]; k++)
    value = call_node(name, value, child[id, k])
  return value
}

# x! of any real x, as in Maxima; Octave's factorial takes integers alone.
function factorial_node(operand)
{
  return call_node("gamma", binary_node("+", operand, number_node("1")), 0)
}

function transpose_node(operand,    id)
{
  must_be_number(operand, "transpose")
  id = new_node("transpose", "", transposed_shape(node_shape[operand]), 0, 0)
  adopt(id, operand)
  return id
}

# The scalar product of two columns, at each time where they have times. Octave multiplies x.'*y in a third of the time
# of its function dot.
function dot_node(left, right,    id)
{
  must_be_number(left, "dot")
  must_be_number(right, "dot")
  if (rows_of(node_shape[left]) != rows_of(node_shape[right]) ||
      !is_column(node_shape[left]) || !is_column(node_shape[right]))
    fail("dot wants two columns of one size, not " node_shape[left] " and " node_shape[right])
  if (node_shape[left] node_shape[right] ~ /times.*times/) {
    id = call_node("sum", binary_node("*", left, right), number_node("1"))
    node_shape[id] = "1-by-times"
  } else if (node_shape[left] ~ /times/)
    id = binary_node(".", transpose_node(right), left)
  else {
    id = binary_node(".", transpose_node(left), right)
    if (node_shape[right] !~ /times/)
      node_shape[id] = "scalar"
  }
  return id
}

function is_column(shape)
{
  return shape == "scalar" || are_columns(shape)
}
