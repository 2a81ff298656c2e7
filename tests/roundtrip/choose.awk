# Random choices.

BEGIN {
  srand(seed)
}

function random(count)
{
  return 1 + int(count * rand())
}

# One of the words of a list.
function word(words,    list)
{
  return list[random(split(words, list, / /))]
}

function digits(count,    text)
{
  text = random(9)
  while (length(text) < count)
    text = text int(10 * rand())
  return text
}
