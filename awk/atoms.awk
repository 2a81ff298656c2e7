# What the parser finds between operators: names, calls, lists and matrices.

BEGIN {
  constant["%pi"] = "pi"
  constant["%e"] = "exp(1)"
  constant["inf"] = "Inf"
  constant["true"] = "true"
  constant["false"] = "false"
}

function parse_name(name)
{
  if (next_is("["))
    return parse_index(name)
  if (name in variable)
    return new_node("name", variable[name], variable_shape[name], variable_truth[name], variable_cover[name])
  if (name in constant)
    return new_node("name", constant[name], "scalar", name ~ /^(true|false)$/, 0)
  if (name == "minf")
    return unary_node("negative", new_node("name", "Inf", "scalar", 0, 0))
  if (name == "%i")
    fail("the imaginary unit %i cannot be translated")
  fail("`" shortened(name) "' is neither an argument nor a temporary that has a value")
}

# x[i], x[i, j] or x[i][j].
function parse_index(name,    id)
{
  if (!(name in variable))
    fail("`" shortened(name) "' is indexed but is neither an argument nor a temporary that has a value")
  id = new_node("index", variable[name], "scalar", variable_truth[name], 0)
  while (next_is("[")) {
    position++
    parse_sequence(id, "]")
  }
  check_index(name, variable_shape[name], id, child_count[id])
  return id
}

# Children of a node up to the closing bracket, at least one.
function parse_sequence(id, closing)
{
  adopt(id, parse(0))
  while (next_is(",")) {
    position++
    adopt(id, parse(0))
  }
  expect(closing)
}

# Maxima prints 'round(x) where it could not evaluate round: the call is meant.
function parse_noun()
{
  if (!(token[position] in function_arity) && token[position] !~ /^(factorial|transpose|dot)$/)
    fail("the noun '" shortened(token[position]) " cannot be translated")
  position++
  return parse_call(token[position - 1])
}

# `name (': an elementwise function of the table, or one of matrices.
function parse_call(name,    id, count)
{
  position++
  if (name == "matrix")
    return parse_matrix()
  if (!(name in function_arity) && name !~ /^(factorial|transpose|dot)$/)
    fail("the function " shortened(name) " cannot be translated")
  id = new_node("arguments", "", "", 0, 0)
  parse_sequence(id, ")")
  count = child_count[id]
  if (name in function_arity ? function_arity[name] != "n" && count != function_arity[name] : count != 1 + (name == "dot"))
    fail("the function " name " cannot have " count " arguments")
  if (name == "factorial")
    return factorial_node(child[id, 1])
  if (name == "transpose")
    return transpose_node(child[id, 1])
  if (name == "dot")
    return dot_node(child[id, 1], child[id, 2])
  return function_arity[name] == "n" ? fold(function_octave[name], id) \
    : call_node(function_octave[name], child[id, 1], count == 2 ? child[id, 2] : 0)
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

# The scalar product of two columns.
function dot_node(left, right,    id)
{
  must_be_number(left, "dot")
  must_be_number(right, "dot")
  if (node_shape[left] != node_shape[right] || node_shape[left] !~ /^(scalar|.*-by-1)$/)
    fail("dot wants two columns of one size, not " node_shape[left] " and " node_shape[right])
  id = new_node("call", "dot", "scalar", 0, 0)
  adopt(id, left)
  adopt(id, right)
  return id
}
