# Lists are columns; matrices, and lists of lists, are given by rows. The elements are scalars.

# `[' has been read.
function parse_list(    id)
{
  id = new_node("list", "", "", 0, 0)
  if (next_is("]"))
    fail("an empty list has no size")
  parse_sequence(id, "]")
  if (node_operator[child[id, 1]] == "list")
    return finish_matrix(id)
  finish_list(id)
  return id
}

function finish_list(id,    k)
{
  for (k = 1; k <= child_count[id]; k++) {
    must_be_number(child[id, k], "[")
    if (node_shape[child[id, k]] != "scalar" || node_operator[child[id, k]] == "list")
      fail("element " k " of a list is not a scalar")
  }
  node_shape[id] = matrix_shape(child_count[id], 1)
}

# `matrix (' has been read.
function parse_matrix(    id)
{
  id = new_node("matrix", "", "", 0, 0)
  if (!next_is("["))
    unexpected("a row is wanted")
  parse_sequence(id, ")")
  return finish_matrix(id)
}

function finish_matrix(id,    k, columns)
{
  node_operator[id] = "matrix"
  columns = child_count[child[id, 1]]
  for (k = 1; k <= child_count[id]; k++)
    if (node_operator[child[id, k]] != "list" || child_count[child[id, k]] != columns)
      fail("row " k " of a matrix is not a list of " columns " elements")
  node_shape[id] = matrix_shape(child_count[id], columns)
  return id
}
