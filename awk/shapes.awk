# Shapes: scalar, array (the common size of the array arguments, elementwise), R-by-C (R, C: integers or names). The
# columns of 1-by-times and R-by-times are scalars and columns at several times: what is constant serves each of them.

# Shape of an elementwise operation on two shapes; Maxima's * / ^ are elementwise on matrices too.
function common_shape(left, right, operation)
{
  if (left == "scalar" || left == right)
    return right
  if (right == "scalar")
    return left
  if (are_columns(left) && are_columns(right) && (left right) ~ /times/)
    if (rows_of(left) == 1 || rows_of(right) == 1 || rows_of(left) == rows_of(right))
      return (rows_of(left) == 1 ? rows_of(right) : rows_of(left)) "-by-times"
  fail("`" operation "' cannot combine " left " and " right)
}

# How much there is to compute: of a number, of one a time or an array, of a matrix, of a column a time.
function extent_of(shape)
{
  return shape == "scalar" ? 0 : shape ~ /^(array|1-by-times)$/ ? 1 : shape ~ /-by-times$/ ? 3 : 2
}

function rows_of(shape)
{
  return shape ~ /-by-/ ? substr(shape, 1, index(shape, "-") - 1) : shape
}

# At one time or at several.
function are_columns(shape)
{
  return shape ~ /-by-(1|times)$/
}

function product_shape(left, right,    l, r)
{
  if (left == "array" || right == "array")
    fail("`.' cannot multiply arrays, only matrices")
  if (left == "scalar" || right == "scalar")
    return common_shape(left, right, ".")
  split(left, l, /-by-/)
  split(right, r, /-by-/)
  if (l[2] != r[1])
    fail("`.' cannot multiply " left " by " right)
  return matrix_shape(l[1], r[2])
}

function transposed_shape(shape,    part)
{
  if (shape == "array")
    fail("transpose wants a matrix, not an array")
  return shape == "scalar" ? shape : split(shape, part, /-by-/) ? matrix_shape(part[2], part[1]) : ""
}

function matrix_shape(rows, columns)
{
  return rows == 1 && columns == 1 ? "scalar" : rows "-by-" columns
}

# name[i] of a vector or name[i, j] of a matrix; integers known here are checked here.
function check_index(name, shape, id, count,    part, k, bound)
{
  if (shape == "scalar" || shape == "array")
    fail(name " cannot be indexed: its shape is " shape)
  split(shape, part, /-by-/)
  if (count > 2 || (count == 1 && part[1] != 1 && part[2] != 1))
    fail(name " has shape " shape ", which " count " indices do not fit")
  for (k = 1; k <= count; k++) {
    if (node_shape[child[id, k]] != "scalar" || node_truth[child[id, k]])
      fail("an index of " name " is not a scalar number")
    bound = count == 1 && part[1] == 1 ? part[2] : part[k]
    check_bound(name, child[id, k], bound)
  }
}

function check_bound(name, index_node, bound,    text)
{
  text = node_text[index_node]
  if (node_operator[index_node] == "negative" || (node_operator[index_node] == "number" \
      && (text !~ /^[1-9][0-9]*$/ || (bound ~ /^[0-9]+$/ && text + 0 > bound + 0))))
    fail("an index of " name " is outside 1 to " bound)
}
