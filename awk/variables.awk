# The function, its arguments and its results, as the record names them.
#
#   argument_octave[k], result_octave[k]          names in Octave
#   variable[name]                                Octave name of an argument or a temporary that the body may mention
#   variable_shape, variable_truth, variable_cover[name]      as in nodes.awk

BEGIN {
  array_count = 0
}

function take_function_name(name)
{
  if (name !~ /^[A-Za-z][A-Za-z0-9_]*$/)
    fail("`" name "' is not an Octave function name")
  if (name in taken || name in is_octave_function)
    fail("the function cannot be called " name ", a name with a meaning in Octave")
  taken[name] = 1
}

function take_argument(value,    field)
{
  split_fields(take_structure(++argument_count, value), field)
  argument_name[argument_count] = field[1]
  argument_shape[argument_count] = field[2]
  argument_unit[argument_count] = field[3]
  argument_meaning[argument_count] = field[4]
  if (field[2] == "array" && ++array_count > 50)
    fail("more than 50 arguments are arrays")
}

function take_result(value,    field)
{
  split_fields(value, field)
  result_name[++result_count] = field[1]
  result_shape[result_count] = field[2]
  result_unit[result_count] = field[3]
  result_meaning[result_count] = field[4]
}

function split_fields(value, field,    dimension)
{
  dimension = "([1-9][0-9]{0,8}|[A-Za-z][A-Za-z0-9_]*)"
  if (split(value, field, / \| /) != 4)
    fail("four fields, name | shape | unit | meaning, are wanted here")
  if (field[1] !~ ("^" maxima_name "$"))
    fail("`" field[1] "' is not a Maxima name")
  if (field[1] in is_listed)
    fail("the name " field[1] " is used twice")
  if (field[2] !~ ("^(scalar|array|" dimension "-by-" dimension ")$"))
    fail("`" field[2] "' is not a shape: scalar, array or R-by-C")
  if (field[2] == "1-by-1") {
    field[2] = "scalar"
    is_single[field[1]] = 1  # a vector of one element, which may be indexed
  }
  is_listed[field[1]] = 1
}

# After the functions that the body calls are known: their names are not free.
function name_arguments_and_results(    k, bit)
{
  bit = 0
  for (k = 1; k <= argument_count; k++) {
    name_argument(k)
    set_variable(argument_name[k], argument_octave[k], argument_shape[k], 0, \
      argument_shape[k] == "array" ? 2^bit++ : 0)
  }
  for (k = 1; k <= result_count; k++)
    result_octave[k] = octave_name(result_name[k])
}

function set_variable(name, octave, shape, truth, cover)
{
  variable[name] = octave
  variable_shape[name] = shape
  variable_truth[name] = truth
  variable_cover[name] = cover
}
