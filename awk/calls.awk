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
  if (name == "sum" || name == "product")
    return parse_repeated(name)
  id = new_node("arguments", "", "", 0, 0)
  parse_sequence(id, ")")
  if (function_arity[name] == "n")
    return fold(function_octave[name], id)
  if (child_count[id] != function_arity[name])
    fail("the function " name " cannot have " child_count[id] " arguments")
  return finish_call(name, id)
}

function finish_call(name, id,    first)
{
  first = child[id, 1]
  if (name == "factorial")
    return factorial_node(first)
  if (name == "transpose")
    return transpose_node(first)
  if (name == "unit_step")
    return if_node(binary_node(">", first, number_node("0")), number_node("1"), number_node("0"))
  if (name == "dot")
    return dot_node(first, child[id, 2])
  if (name == "equal" || name == "notequal")
    return binary_node(name == "equal" ? "=" : "#", first, child[id, 2])
  if (name ~ /^gamma_incomplete/)
    return incomplete_gamma_node(name, first, child[id, 2])
  if (name == "beta_incomplete_regularized")
    return with_argument(with_argument(call_node("betainc", child[id, 3]), first), child[id, 2])
  return child_count[id] == 1 ? call_node(function_octave[name], first) \
    : with_argument(call_node(function_octave[name], first), child[id, 2])
}

# Octave has the variable before the order, and the regularized function.
function incomplete_gamma_node(name, order, operand,    id)
{
  id = with_argument(call_node("gammainc", operand), order)
  adopt(id, new_node("name", "\"upper\"", "scalar", 0, 0))
  return name == "gamma_incomplete" ? binary_node("*", id, call_node("gamma", order)) : id
}

# Octave's max and min take two.
function fold(name, id,    k, value)
{
  must_be_number(child[id, 1], name)
  value = child[id, 1]
  for (k = 2; k <= child_count[id]; k++)
    value = with_argument(call_node(name, value), child[id, k])
  return value
}

# x! of any real x, as in Maxima; Octave's factorial takes integers alone.
function factorial_node(operand)
{
  return call_node("gamma", binary_node("+", operand, number_node("1")))
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
    id = with_argument(call_node("sum", binary_node("*", left, right)), number_node("1"))
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
