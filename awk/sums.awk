# 'sum (term, k, first, last) and 'product likewise, with finite bounds; the index k is known in the term alone.

# The name and `(' have been read. The index stands behind the term, so it is looked up first.
function parse_repeated(name,    index_name, kept, id, k)
{
  index_name = index_ahead(name)
  hide_variable(index_name, kept)
  set_variable(index_name, "octave" in kept ? kept["octave"] : octave_name(index_name), "scalar", 0, 0)
  id = new_node("call", function_octave[name], "scalar", 0, 0)
  adopt(id, index_function(variable[index_name], parse(0), name))
  restore_variable(index_name, kept)
  expect(",")
  position++
  for (k = 2; k <= 3; k++) {
    expect(",")
    adopt(id, parse(0))
    check_bound_of(name, child[id, k])
  }
  expect(")")
  node_shape[id] = node_shape[child[id, 1]]
  return id
}

function index_ahead(name,    k, depth)
{
  depth = 0
  for (k = position; k <= token_count && (depth > 0 || token[k] !~ /^[,)\]]$/); k++)
    depth += (token[k] ~ /^[(\[]$/) - (token[k] ~ /^[)\]]$/)
  if (token[k] != "," || token[k + 1] !~ ("^" maxima_name "$") || token[k + 2] != ",")
    fail("the function " name " wants a term, the name of its index, and two bounds")
  return token[k + 1]
}

# @(k) term
function index_function(octave, term, name,    id)
{
  must_be_number(term, name)
  if (node_shape[term] !~ /^(scalar|array)$/)
    fail("the terms of " name " are scalars or arrays, not " node_shape[term])
  id = new_node("function", octave, node_shape[term], 0, 0)
  adopt(id, term)
  return id
}

function check_bound_of(name, id)
{
  must_be_number(id, name)
  if (node_shape[id] != "scalar")
    fail("a bound of " name " must be a scalar, not " node_shape[id])
  if (is_infinite(id))
    fail("an infinite " name " cannot be translated")
}

function is_infinite(id)
{
  while (node_operator[id] == "negative")
    id = child[id, 1]
  return node_operator[id] == "name" && node_text[id] == "Inf"
}

# An argument of the index's name means the index inside the term.
function hide_variable(name, kept)
{
  delete kept
  if (!(name in variable))
    return
  kept["octave"] = variable[name]
  kept["shape"] = variable_shape[name]
  kept["truth"] = variable_truth[name]
  kept["cover"] = variable_cover[name]
  if (name in is_single) {
    kept["single"] = 1
    delete is_single[name]
  }
}

function restore_variable(name, kept)
{
  if (!("octave" in kept)) {
    delete variable[name]
    return
  }
  set_variable(name, kept["octave"], kept["shape"], kept["truth"], kept["cover"])
  if ("single" in kept)
    is_single[name] = 1
}
