# Size checks. They run in every call of a hot loop, where each call of a builtin counts, so few of them decide whether
# all is well: size_equal for all arguments of one shape, then rows and columns of the first of each R-by-C shape.
# Arrays of several sizes may still be right, scalars beside arrays: check_sizes.m looks closely.

BEGIN {
  test_count = 0
}

function put_checks(    k)
{
  put("  if (nargin != " parameter_count ")")
  put("    print_usage ();")
  put("  endif")
  put_fields()
  name_dimensions()
  collect_tests()
  if (!test_count)
    return
  emit("  if (")
  for (k = 1; k <= test_count; k++)
    emit_list(test[k] (k < test_count ? " || " : ")"))
  put_pieces()
  put_close_look()
  put("  endif")
}

# Commas are good places for the end of a line.
function emit_list(text,    part, count, k)
{
  count = split(text, part, /, /)
  for (k = 1; k <= count; k++)
    emit(part[k] (k < count ? ", " : ""))
}

# `n = rows (V);' for the first argument that has the dimension.
function name_dimensions(    k, part)
{
  for (k = 1; k <= argument_count; k++)
    if (split(argument_shape[k], part, /-by-/) == 2) {
      name_dimension(part[1], "rows (" argument_octave[k] ")")
      name_dimension(part[2], "columns (" argument_octave[k] ")")
    }
}

function name_dimension(dimension, value)
{
  if (dimension ~ /^[0-9]/ || dimension in dimension_octave)
    return
  dimension_octave[dimension] = octave_name(dimension)
  dimension_value[dimension] = value
  put("  " dimension_octave[dimension] " = " value ";")
}

function dimension_text(dimension)
{
  return dimension in dimension_octave ? dimension_octave[dimension] : dimension
}

# alike[shape] lists the arguments of the shape, separated by commas.
function collect_tests(    k, shape, alike, first)
{
  alike["scalar"] = "1"
  for (k = 1; k <= argument_count; k++) {
    shape = argument_shape[k]
    if (!(shape in alike))
      first[k] = shape
    alike[shape] = shape in alike ? alike[shape] ", " argument_octave[k] : argument_octave[k]
  }
  if (alike["scalar"] ~ /,/)
    add_test("! size_equal (" alike["scalar"] ")")
  for (k = 1; k <= argument_count; k++)
    if (k in first) {
      if (alike[first[k]] ~ /,/)
        add_test("! size_equal (" alike[first[k]] ")")
      add_matrix_tests(first[k], argument_octave[k])
    }
}

# The argument that names a dimension has it.
function add_matrix_tests(shape, argument,    part)
{
  if (split(shape, part, /-by-/) < 2)
    return
  add_dimension_test(part[1], "rows (" argument ")")
  add_dimension_test(part[2], "columns (" argument ")")
}

function add_dimension_test(dimension, value)
{
  if (!(dimension in dimension_value) || dimension_value[dimension] != value)
    add_test(value " != " dimension_text(dimension))
}

function add_test(text)
{
  test[++test_count] = text
}
