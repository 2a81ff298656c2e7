# The tree. Each node is made whole, with its shape:
#
#   node_operator[id]       number, name, negative, not, call, function (@(k) child), index, list, matrix,
#                           arguments, if, transpose or an infix operator
#   node_text[id]           digits, Octave name or text
#   child[id, k], child_count[id]
#   node_shape[id]          see shapes.awk
#   node_truth[id]          1 for conditions, 0 for numbers
#   node_cover[id]          set (of bits) of the array arguments whose size the value surely has

BEGIN {
  node_count = 0
}

function new_node(operator, text, shape, truth, cover)
{
  node_operator[++node_count] = operator
  node_text[node_count] = text
  node_shape[node_count] = shape
  node_truth[node_count] = truth
  node_cover[node_count] = cover
  child_count[node_count] = 0
  return node_count
}

function adopt(parent, id)
{
  child[parent, ++child_count[parent]] = id
}

function number_node(text)
{
  return new_node("number", octave_number(text), "scalar", 0, 0)
}

function unary_node(operator, operand,    id)
{
  if (operator == "not")
    must_be_condition(operand, operator)
  else
    must_be_number(operand, operator)
  id = new_node(operator, "", node_shape[operand], operator == "not", node_cover[operand])
  adopt(id, operand)
  return id
}

# Infix operators: + - * / ^ elementwise, . of matrices, relations, and, or.
function binary_node(operator, left, right)
{
  check_kind(left, operator)
  check_kind(right, operator)
  if (operator == "/")
    shorten_quotient(left, right)
  if (operator == "." && (node_shape[left] == "scalar" || node_shape[right] == "scalar"))
    operator = "*"
  return operator == "*" ? product_node(left, right) : infix_node(operator, left, right)
}

# A factor goes before the larger ones of a product: V*a*b is a*b*V, where numbers are multiplied first.
function product_node(left, right,    first)
{
  if (node_operator[left] != "*" || extent_of(node_shape[right]) >= extent_of(node_shape[child[left, 2]]))
    return infix_node("*", left, right)
  first = child[left, 1]
  if (node_operator[first] ~ /^[*\/]$/ || starts_negative(first) || \
      extent_of(node_shape[right]) >= extent_of(node_shape[first]))
    return infix_node("*", product_node(first, right), child[left, 2])
  return infix_node("*", infix_node("*", right, first), child[left, 2])
}

function infix_node(operator, left, right,    id, shape)
{
  if (operator == ".")
    shape = product_shape(node_shape[left], node_shape[right])
  else
    shape = common_shape(node_shape[left], node_shape[right], operator)
  id = new_node(operator, "", shape, operator ~ /^([=#<>]|<=|>=|and|or)$/, or(node_cover[left], node_cover[right]))
  adopt(id, left)
  adopt(id, right)
  return id
}

# An Octave function of one elementwise argument, and of one more.
function call_node(name, argument)
{
  return with_argument(new_node("call", name, "scalar", 0, 0), argument)
}

function with_argument(id, argument)
{
  must_be_number(argument, node_text[id])
  node_shape[id] = common_shape(node_shape[id], node_shape[argument], node_text[id])
  node_cover[id] = or(node_cover[id], node_cover[argument])
  adopt(id, argument)
  return id
}

# With an array as condition the value has its size; otherwise the size of one branch or the other.
function if_node(condition, yes, no,    id, shape)
{
  must_be_condition(condition, "if")
  if (node_truth[yes] != node_truth[no])
    fail("one branch of `if' is a condition and the other a number")
  shape = common_shape(node_shape[yes], node_shape[no], "if")
  shape = common_shape(node_shape[condition], shape, "if")
  id = new_node("if", "", shape, node_truth[yes], or(node_cover[condition], and(node_cover[yes], node_cover[no])))
  adopt(id, condition)
  adopt(id, yes)
  adopt(id, no)
  return id
}
