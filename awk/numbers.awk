# Numbers. A double holds no more than 1.8e308, Maxima's integers have any length.

BEGIN {
  realmax = 1.7976931348623157e308
  kept_digits = 40
}

# Octave's text of a Maxima number: 1.5b-10 is 1.5e-10, .5 is 0.5, 3.d2 is 3.0e2; 2. is the integer 2.
function octave_number(text)
{
  text = tolower(text "")
  sub(/[bdfsl]/, "e", text)
  sub(/[.]$/, "", text)
  sub(/[.]e/, ".0e", text)
  sub(/^0+/, "", text)
  if (text !~ /^[0-9]/)
    text = "0" text
  if (!is_integer(text) && text + 0 > realmax)
    fail(shortened(text) " is too large for Octave's numbers")
  return text
}

function is_integer(text)
{
  return text ~ /^[0-9]+$/
}

# Only when it is printed: as part of a quotient an integer may be longer.
function check_integer(text)
{
  if (is_integer(text) && text + 0 > realmax)
    fail("an integer of " length(text) " digits is too large for Octave's numbers")
}

# (N*x)/(D*y) with long integers N and D: divide both by the power of ten that leaves D between 1 and 10.
function shorten_quotient(numerator, denominator,    digits)
{
  numerator = leading_integer(numerator)
  denominator = leading_integer(denominator)
  if (!numerator || !denominator)
    return
  if (length(node_text[numerator]) <= kept_digits && length(node_text[denominator]) <= kept_digits)
    return
  long_integer[numerator] = node_text[numerator]
  long_integer[denominator] = node_text[denominator]
  digits = length(node_text[denominator]) - 1
  node_text[numerator] = scaled_integer(node_text[numerator], digits)
  node_text[denominator] = scaled_integer(node_text[denominator], digits)
}

# The integer that starts a product, as Maxima prints rational coefficients; 0 if there is none.
function leading_integer(id)
{
  while (node_operator[id] == "*" || node_operator[id] == "negative")
    id = child[id, 1]
  return node_operator[id] == "number" && is_integer(node_text[id]) ? id : 0
}

function scaled_integer(text, digits,    fraction)
{
  digits = length(text) - 1 - digits
  fraction = text
  sub(/^./, "", fraction)
  if (length(fraction) >= kept_digits)
    fraction = substr(fraction, 1, kept_digits - 1)
  sub(/0+$/, "", fraction)
  return octave_number(substr(text, 1, 1) "." (fraction == "" ? "0" : fraction) (digits ? "e" digits : ""))
}
