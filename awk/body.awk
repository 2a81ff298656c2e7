# The body: an expression, a list of expressions if the record has several results, or a block that ends with either.
#
#   statement_count, statement_name[k], statement_value[k]     temporaries, in their order
#   temporary_value[name]                                      the same by name, while it holds
#   result_value[k]

BEGIN {
  statement_count = 0
}

function parse_body(    k)
{
  if (next_is("block") && token[position + 1] == "(")
    parse_block()
  else
    parse_results()
  if (!next_is(""))
    unexpected("the end is wanted")
  for (k = 1; k <= result_count; k++)
    fit_result(k)
}

function parse_block(    declared, name)
{
  position += 2
  parse_declarations(declared)
  while (token[position + 1] == ":") {
    name = advance()
    if (!(name in declared))
      fail("`" shortened(name) "' is assigned but not declared by the block")
    position++
    assign(name, parse(20))
    expect(",")
  }
  parse_results()
  expect(")")
}

function parse_declarations(declared)
{
  expect("[")
  if (!next_is("]")) {
    declare(advance(), declared)
    while (next_is(",")) {
      position++
      declare(advance(), declared)
    }
  }
  expect("]")
  expect(",")
}

function declare(name, declared)
{
  if (name !~ ("^" maxima_name "$"))
    fail("`" shortened(name) "' is not a name that a block can declare")
  if (name in variable)
    fail("the temporary " name " is also an argument")
  declared[name] = 1
}

function assign(name, value)
{
  if (name in variable)
    delete temporary_value  # the values of others may mention it
  set_variable(name, name in variable ? variable[name] : octave_name(name), \
    node_shape[value], node_truth[value], node_cover[value])
  statement_name[++statement_count] = variable[name]
  statement_value[statement_count] = value
  temporary_value[name] = value
}

function parse_results(    k)
{
  if (result_count == 1) {
    result_value[1] = parse(0)
    return
  }
  expect("[")
  for (k = 1; k <= result_count; k++) {
    result_value[k] = parse(0)
    expect(k < result_count ? "," : "]")
  }
}
