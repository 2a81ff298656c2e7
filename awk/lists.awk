# Lists are columns; matrices, and lists of lists, are given by rows. The elements are scalars.

# `[' has been read.
function parse_list(    id)
{
  id = new_node("list", "", "", 0, 0)
  if (next_is("]"))
    fail("an empty list has no size")
  parse_rows(id, "]")
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
  if (!next_is("[") && !(token[position] in temporary_value))
    unexpected("a row is wanted")
  parse_rows(id, ")")
  return finish_matrix(id)
}

# Maxima's optimize names a row that stands twice.
function parse_rows(id, closing,    k, row)
{
  parse_sequence(id, closing)
  for (k = 1; k <= child_count[id]; k++) {
    row = child[id, k]
    if (row in definition && node_operator[definition[row]] == "list")
      child[id, k] = definition[row]
  }
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
