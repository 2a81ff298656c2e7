# Print a tree as pieces of Octave text: piece[1] to piece[piece_count]. Lines may be broken after some pieces, see
# lines.awk. Parentheses follow Octave's precedences: its ^ is left associative, its unary minus binds less than ^.

BEGIN {
  precedence["or"] = 3
  precedence["and"] = 4
  precedence["="] = precedence["#"] = precedence["<"] = precedence["<="] = precedence[">"] = precedence[">="] = 5
  precedence["+"] = precedence["-"] = 6
  precedence["*"] = precedence["/"] = precedence["."] = 7
  precedence["negative"] = precedence["not"] = 8
  precedence["^"] = precedence["^^"] = precedence["transpose"] = 9
  primary = 10

  octave_operator["="] = "=="
  octave_operator["#"] = "!="
  octave_operator["."] = "*"
  octave_operator["^^"] = "^"
}

# Octave's scalar || and && bind less than | and &.
function precedence_of(id,    operator)
{
  operator = node_operator[id]
  if ((operator == "or" || operator == "and") && node_shape[id] == "scalar")
    return precedence[operator] - 2
  return operator in precedence ? precedence[operator] : primary
}

function emit(text)
{
  piece[++piece_count] = text
}

function print_node(id, least,    enclosed)
{
  enclosed = precedence_of(id) < least
  if (enclosed)
    emit("(")
  print_bare(id, node_operator[id])
  if (enclosed)
    emit(")")
}

function print_bare(id, operator)
{
  if (operator == "number" || operator == "name") {
    check_integer(node_text[id])
    emit(node_text[id])
  } else if (operator == "call")
    print_call(node_text[id], id)
  else if (operator == "if")
    print_call("merge", id)
  else if (operator == "index")
    print_arguments(node_text[id], id)
  else if (operator == "function") {
    emit("@(" node_text[id] ") ")
    print_node(child[id, 1], 0)
  } else if (operator == "list")
    print_elements("[", id, "; ", "]")
  else if (operator == "matrix")
    print_matrix(id)
  else if (operator == "transpose") {
    print_node(child[id, 1], primary)
    emit(".'")
  } else if (operator == "negative" || operator == "not") {
    emit(operator == "not" ? "!" : "-")
    print_node(child[id, 1], precedence["negative"] + 1)
  } else
    print_infix(id, operator)
}

function print_call(name, id)
{
  operations["call"]++
  is_called[name] = 1
  print_arguments(name, id)
}

function print_arguments(name, id)
{
  emit(name "(")
  print_elements("", id, ", ", ")")
}

function print_elements(opening, id, separator, closing,    k)
{
  emit(opening)
  for (k = 1; k <= child_count[id]; k++) {
    print_node(child[id, k], 0)
    emit(k < child_count[id] ? separator : closing)
  }
}

function print_matrix(id,    k)
{
  emit("[")
  for (k = 1; k <= child_count[id]; k++)
    print_elements("", child[id, k], ", ", k < child_count[id] ? "; " : "]")
}
