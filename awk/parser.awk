# The Pratt parser, with the binding powers of Maxima's own reader (nparse.lisp). Each function returns a node.

BEGIN {
  left_power["!"] = 160
  left_power["^"] = left_power["**"] = left_power["^^"] = 140
  right_power["^"] = right_power["**"] = right_power["^^"] = 139
  left_power["."] = 130; right_power["."] = 129
  left_power["*"] = right_power["*"] = left_power["/"] = right_power["/"] = 120
  left_power["+"] = right_power["+"] = left_power["-"] = right_power["-"] = 100
  left_power["="] = right_power["="] = left_power["#"] = right_power["#"] = 80
  left_power["<"] = left_power["<="] = left_power[">"] = left_power[">="] = 80
  right_power["<"] = right_power["<="] = right_power[">"] = right_power[">="] = 80
  left_power["and"] = right_power["and"] = 65
  left_power["or"] = right_power["or"] = 60
  sign_power = 134
  not_power = 70
  if_power = 45
  branch_power = 25
  deepest_nesting = 1000
  nesting = 0
}

# The longest expression whose operators bind tighter than the given power.
function parse(power,    left, operator)
{
  if (++nesting > deepest_nesting)
    fail("the expression is nested more than " deepest_nesting " deep")
  left = parse_prefix()
  while ((token[position] in left_power) && left_power[token[position]] > power) {
    operator = advance()
    if (operator == "!")
      left = factorial_node(left)
    else if (operator == "^" || operator == "**")
      left = power_node(left, parse(right_power[operator]))
    else if (operator == "^^")
      left = matrix_power_node(left, parse(right_power[operator]))
    else
      left = binary_node(operator, left, parse(right_power[operator]))
  }
  nesting--
  return left
}

function parse_prefix(    word, id)
{
  word = advance()
  if (word ~ /^[.]?[0-9]/)
    return number_node(word)
  if (word == "-")
    return unary_node("negative", parse(sign_power))
  if (word == "+")
    return parse(sign_power)
  if (word == "(") {
    id = parse(0)
    expect(")")
    return id
  }
  if (word == "[")
    return parse_list()
  if (word == "not")
    return unary_node("not", parse(not_power))
  if (word == "if")
    return parse_if()
  if (word == "'")
    return parse_noun()
  if (word ~ /^[A-Za-z_%?\\]/)
    return next_is("(") ? parse_call(word) : parse_name(word)
  position--
  if (word ~ /^"/)
    fail("the string " shortened(word) " cannot be translated")
  unexpected("an expression is wanted")
}

# `if' or `elseif' has been read.
function parse_if(    condition, yes, no)
{
  condition = parse(if_power)
  expect("then")
  yes = parse(branch_power)
  if (next_is("elseif")) {
    position++
    if (++nesting > deepest_nesting)
      fail("the expression is nested more than " deepest_nesting " deep")
    no = parse_if()
    nesting--
  } else {
    expect("else")
    no = parse(branch_power)
  }
  return if_node(condition, yes, no)
}
