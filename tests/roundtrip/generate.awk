# Write `count' random expressions as statements of evaluate.mac, `batch' to a record, and the shape of each to the
# file `shapes'. Every second record is read without simplification, so that Maxima prints what was written here;
# every fourth becomes the block of optimize.

BEGIN {
  for (k = 1; k <= count; k++) {
    record = int((k - 1) / batch) + 1
    optimized = record % 4 == 3
    if (k % batch == 1 || batch == 1)
      print "simplify (" (record % 2 ? "true" : "false") ")$"
    expression = random_expression()
    print record, shape >shapes
    print "expression ('(" expression "), " (shape == "array" ? "true" : "false") ")$"
    if (k % batch == 0 || k == count)
      print "record (" (optimized ? "true" : "false") ")$"
  }
}

function random_expression(    kind)
{
  kind = random(20)
  arrays = 0
  if (kind == 1)
    return with_shape("n-by-1", column(2))
  if (kind == 2)
    return with_shape("n-by-n", square(1))
  if (kind == 3)
    return with_shape("2-by-3", two_by_three())
  if (kind == 4)
    return with_shape("3-by-1", "[" number(2) ",-" number(1) "," leaf() "-" number(0) "]")
  if (kind == 5)
    return with_shape("2-by-2", "[[" number(1) ",-a],[" number(0) "-b," number(1) "]]")
  if (kind == 6)
    return with_shape("2-by-2", "R . transpose(R)")
  if (kind == 7)
    return with_shape("scalar", number(3))
  arrays = 1
  return with_shape("array", kind == 8 ? condition(2) : number(3))
}

function with_shape(name, text)
{
  shape = name
  return text
}
