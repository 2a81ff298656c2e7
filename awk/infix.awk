# Print infix operators, dotted where both sides may be arrays or matrices, and count the operations.

function print_infix(id, operator,    left, right, level)
{
  left = child[id, 1]
  right = child[id, 2]
  level = precedence_of(id)
  print_node(left, operator ~ /^([=#<>]|<=|>=)$/ ? level + 1 : level)
  emit(infix_text(id, operator))
  print_node(right, starts_negative(right) ? primary : level + 1)
}

# -y, -y*z: correct but unpleasant after another operator.
function starts_negative(id)
{
  while (node_operator[id] ~ /^[*\/.]$/)
    id = child[id, 1]
  return node_operator[id] == "negative"
}

function infix_text(id, operator,    dot)
{
  if (operator == "and" || operator == "or")
    return node_shape[id] == "scalar" ? (operator == "and" ? " && " : " || ") : (operator == "and" ? " & " : " | ")
  if (operator == "+" || operator == "-") {
    operations["addition"]++
    return " " operator " "
  }
  if (operator in operation_name) {
    operations[operation_name[operator]]++
    dot = is_dotted(operator, node_shape[child[id, 1]], node_shape[child[id, 2]])
    return (dot ? "." : "") (operator in octave_operator ? octave_operator[operator] : operator)
  }
  return " " (operator in octave_operator ? octave_operator[operator] : operator) " "
}

function is_dotted(operator, left, right)
{
  if (operator == "*")
    return left != "scalar" && right != "scalar"
  if (operator == "/")
    return right != "scalar"
  return operator == "^" && (left != "scalar" || right != "scalar")
}

BEGIN {
  operation_name["*"] = operation_name["."] = "multiplication"
  operation_name["/"] = "division"
  operation_name["^"] = operation_name["^^"] = "power"
  operations["addition"] = operations["multiplication"] = operations["division"] = 0
  operations["power"] = operations["call"] = 0
}

# `12 additions, 1 power', in a fixed order.
function operation_summary(    list, k, count, name, text)
{
  count = split("addition multiplication division power call", list, / /)
  text = ""
  for (k = 1; k <= count; k++) {
    name = list[k]
    if (operations[name])
      text = text (text == "" ? "" : ", ") operations[name] " " name (operations[name] > 1 ? "s" : "")
  }
  return text == "" ? "no operations" : text
}
