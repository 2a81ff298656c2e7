# Collect the lines of the generated file; long ones are broken at about 110 columns.

BEGIN {
  widest = 110
  output_count = 0
  piece_count = 0
}

function put(line)
{
  output[++output_count] = line
}

# The pieces as one statement. A line may end after a separator or an infix operator: also between brackets, where
# Octave takes blanks for commas, such a line goes on.
function put_pieces()
{
  put_broken(" ...", "      ")
}

# The same in a comment of Texinfo.
function put_comment_pieces()
{
  put_broken(" @", "##   ")
}

function put_broken(line_end, line_start,    line, k, chunk, fresh)
{
  fresh = 1
  line = chunk = ""
  for (k = 1; k <= piece_count; k++) {
    chunk = chunk piece[k]
    if (k < piece_count && !may_break(piece[k], length(chunk)))
      continue
    if (!fresh && length(line chunk) > widest - length(line_end)) {
      sub(/ +$/, "", line)
      put(line line_end)
      line = line_start
    }
    line = line chunk
    fresh = 0
    chunk = ""
  }
  put(line)
  piece_count = 0
}

# Sums break before products do.
function may_break(text, chunk_length)
{
  return text ~ / $/ || (chunk_length > widest / 2 && text ~ /[*\/]$/)
}

function put_assignment(name, value)
{
  emit("  " name " = ")
  print_node(value, 0)
  emit(";")
  put_pieces()
}
