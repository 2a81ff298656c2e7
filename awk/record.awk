# Read a record: lines `key: value' in a fixed order, closed by a line that names the function once more, so that a
# truncated file is never trusted.
#
#   record[key]                 value of function, summary, equation, origin, body
#   argument_count, argument_name[k], argument_shape[k], argument_unit[k], argument_meaning[k]
#   result_count, result_name[k], ...  likewise
#   record_file, record_line    place named by fail

function fail(message)
{
  printf "maxima2octave: %s:%d: %s\n", record_file, record_line, message >"/dev/stderr"
  close("/dev/stderr")
  exit 1
}

function read_record(file,    line, line_count, newline, status)
{
  record_file = file
  record_line = line_count = argument_count = result_count = 0
  newline = "\n"
  while ((status = (getline line[line_count + 1] <file)) > 0) {
    line_count++
    newline = RT
  }
  if (status < 0)
    fail("cannot read the file")
  close(file)
  wanted_key = "maxima2octave"
  while (record_line < line_count) {
    record_line++
    read_line(line[record_line])
  }
  if (wanted_key != "nothing" || newline != "\n")
    fail("the file is cut short: it must end with the whole line `end: " record["function"] "'")
  record_line = body_line
}

function read_line(line,    key, value)
{
  if (length(line) > 1000000)
    fail("the line is longer than 1000000 characters")
  if (line !~ /^[ -~]*$/)
    fail("a byte is not printable ASCII")
  if (!match(line, /^[a-z0-9]+: +[^ ]/))
    fail("the line must read `key: value'")
  key = substr(line, 1, index(line, ":") - 1)
  value = substr(line, RLENGTH)
  if (!may_come(key))
    fail((wanted_key == "nothing" ? "nothing may follow end:" : wanted_key ": must come here") ", not " key ":")
  take_field(key, value)
}

# wanted_key comes next; where an argument is wanted a result will do, and the body may follow a result.
function may_come(key)
{
  return key == wanted_key || (key == "result" && wanted_key == "argument") \
    || (key == "body" && wanted_key == "result" && result_count > 0)
}

function take_field(key, value)
{
  record[key] = value
  wanted_key = next_key[key]
  if (key == "maxima2octave" && value != "1")
    fail("this translator reads format 1, not " value)
  else if (key == "function")
    take_function_name(value)
  else if (key == "argument")
    take_argument(value)
  else if (key == "result")
    take_result(value)
  else if (key == "body")
    body_line = record_line
  else if (key == "end" && value != record["function"])
    fail("end: names " value ", not " record["function"])
}

BEGIN {
  record["function"] = ""
  next_key["maxima2octave"] = "function"
  next_key["function"] = "summary"
  next_key["summary"] = "equation"
  next_key["equation"] = "origin"
  next_key["origin"] = next_key["argument"] = "argument"
  next_key["result"] = "result"
  next_key["body"] = "end"
  next_key["end"] = "nothing"
}
