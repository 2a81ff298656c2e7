# Write files that no translator may accept: every true prefix of the good record given as input, `count' files of
# random bytes, half of them as a body in a record, and a few monsters.

{ good = good $0 "\n" }

END {
  srand(20)
  ORS = ""
  for (k = 0; k < length(good); k++)
    write("prefix_" k, substr(good, 1, k))
  for (k = 1; k <= count; k++)
    write("bytes_" k, k % 2 ? random_bytes() : with_body(random_bytes()))
  write("opening", with_body(repeated("(", 100000)))
  write("nested", with_body(repeated("(", 100000) "1" repeated(")", 100000)))
  write("signs", with_body(repeated("-", 100000) "1"))
  write("powers", with_body(repeated("2^", 100000) "1"))
  write("conditions", with_body(repeated("if 1 < 2 then 1 else", 40000) " 1"))
  write("integer", with_body(repeated("9", 400)))
  write("long", with_body(repeated("1+", 3000000) "1"))
}

function write(name, text)
{
  print text >(folder "/" name)
  close(folder "/" name)
}

function random_bytes(    length_wanted, text)
{
  length_wanted = int(400 * rand()) + 20
  while (length(text) < length_wanted)
    text = text sprintf("%c", int(256 * rand()))
  return text
}

function with_body(body,    record)
{
  record = good
  sub(/\nbody: [^\n]*\n.*/, "", record)
  return record "\nbody: " body "\nend: rod_mass\n"
}

function repeated(text, times,    result)
{
  result = sprintf("%" times "s", "")
  gsub(/ /, text, result)
  return result
}
