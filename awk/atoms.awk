# What the parser finds between operators: names, constants and indexed names.

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
    return variable_node(name)
  if (name in constant)
    return new_node("name", constant[name], "scalar", name ~ /^(true|false)$/, 0)
  if (name == "minf")
    return unary_node("negative", new_node("name", "Inf", "scalar", 0, 0))
  if (name == "%i")
    fail("the imaginary unit %i cannot be translated")
  fail("`" shortened(name) "' is neither an argument nor a temporary that has a value")
}

function variable_node(name,    id)
{
  id = new_node("name", variable[name], variable_shape[name], variable_truth[name], variable_cover[name])
  if (name in temporary_value)
    definition[id] = temporary_value[name]
  return id
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
  check_index(name, name in is_single ? "1-by-1" : variable_shape[name], id, child_count[id])
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
