# Cut a body into tokens, token[1] to token[token_count], then an empty one; token_gap[k] is the blank after token[k].

BEGIN {
  number_pattern = "([0-9]+([.][0-9]*)?|[.][0-9]+)([eEbBdDfFsSlL][-+]?[0-9]+)?"  # Maxima's: 2. is 2, 3.E+2 is 300.0
  token_pattern = number_pattern "|" maxima_name "|\"([^\"\\\\]|\\\\.)*\"" \
    "|[*][*]|[\\^][\\^]|<=|>=|:=|::=|::|!!|[-+*/.^=#<>!:,()'\\[\\]]"
}

function cut_into_tokens(body,    k)
{
  token_count = patsplit(body, token, token_pattern, token_gap)
  for (k = 0; k <= token_count; k++)
    if (token_gap[k] !~ /^ *$/)
      fail("`" substr(token_gap[k], match(token_gap[k], /[^ ]/), 1) "' has no meaning in an expression")
  token[token_count + 1] = ""
  position = 1
}

function next_is(text)
{
  return token[position] == text
}

function advance()
{
  return token[position++]
}

function expect(text)
{
  if (!next_is(text))
    unexpected("`" text "' is wanted")
  position++
}

function unexpected(wish,    k, before)
{
  before = ""
  for (k = position > 6 ? position - 6 : 1; k < position; k++)
    before = before token[k] (k < position - 1 ? token_gap[k] : "")
  fail(wish (before == "" ? "" : " after `" shortened(before) "'") \
    ", not " (next_is("") ? "the end" : "`" shortened(token[position]) "'"))
}

function shortened(text)
{
  return length(text) > 60 ? "..." substr(text, length(text) - 56) : text
}
