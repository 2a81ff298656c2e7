# The slow half of the size checks: a call of check_sizes with every argument, and check_sizes itself, a local function
# of the generated file.

function put_close_look(    k)
{
  emit("    check_sizes (\"" record["function"] "\", {")
  for (k = 1; k <= argument_count; k++)
    emit("\"" argument_octave[k] "\", " argument_octave[k] ", " size_text(argument_shape[k]) \
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

function put_check_sizes()
{
  put("")
  put("## Name the first argument of a wrong size. Arrays, with [] for their size, are scalars or of equal sizes.")
  put("function check_sizes (caller, checked)")
  put("  written = @(sizes) sprintf (\"-by-%d\", sizes)(5:end);")
  put("  common = [];")
  put("  for k = 1:rows (checked)")
  put("    [name, value, expected] = checked{k,:};")
  put("    if (isempty (expected) && isscalar (value))")
  put("      continue;")
  put("    elseif (isempty (expected))")
  put("      if (isempty (common))")
  put("        common = size (value);")
  put("      endif")
  put("      expected = common;")
  put("    endif")
  put("    if (! isequal (size (value), expected))")
  put("      error (\"%s: %s must be %s, not %s\", caller, name, written (expected), written (size (value)));")
  put("    endif")
  put("  endfor")
  put("endfunction")
}
