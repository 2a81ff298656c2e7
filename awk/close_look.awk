# The slow half of the size checks: a call of check_sizes.m, beside the function, with every argument.

function put_close_look(    k)
{
  emit("    check_sizes (\"" record["function"] "\", {")
  for (k = 1; k <= argument_count; k++)
    emit("\"" argument_label[k] "\", " argument_octave[k] ", " size_text(argument_shape[k]) \
      (k < argument_count ? "; " : "});"))
  put_pieces()
}

# "[n, 1]" for n-by-1, "[]" for an array.
function size_text(shape,    part)
{
  if (shape == "array")
    return "[]"
  if (shape == "scalar")
    return "[1, 1]"
  split(shape, part, /-by-/)
  return "[" dimension_text(part[1]) ", " dimension_text(part[2]) "]"
}
