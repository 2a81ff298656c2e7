# Give each result the shape that the record promises.

# A value that may lack the size of some arrays gets it by an operation with zeros of that size.
function fit_result(k,    value, missing)
{
  value = result_value[k]
  if (node_shape[value] != result_shape[k] && !(result_shape[k] == "array" && node_shape[value] == "scalar"))
    fail("the result " result_name[k] " has shape " node_shape[value] ", not " result_shape[k])
  missing = result_shape[k] == "array" ? arrays_outside(node_cover[value]) : ""
  if (missing != "")
    result_value[k] = sized_node(value, missing)
}

# `x + y' for the array arguments that are not in the set.
function arrays_outside(cover,    k, bit, list)
{
  list = ""
  bit = 0
  for (k = 1; k <= argument_count; k++)
    if (argument_shape[k] == "array" && !and(cover, 2^bit++))
      list = list (list == "" ? "" : " + ") argument_octave[k]
  return list
}

function sized_node(value, arrays,    truth, filler)
{
  truth = node_truth[value]
  filler = new_node("name", (truth ? "false" : "zeros") "(size(" arrays "))", "array", truth, 0)
  return binary_node(truth ? "or" : "+", value, filler)
}
