# Random conditions, and what jumps: both sides must see the same jump, so sums of dyadic fractions are used.

function exact()
{
  return word("1 2 3") "*" variable() word("+ -") word("1 1/2 3/2 1/4") "*" variable() word("+ -") word("1/2 3/8 2")
}

function variable()
{
  return arrays ? word("x y a b") : word("a b")
}

function rounded()
{
  return word("floor ceiling round truncate signum entier round") "(" exact() ")*" leaf() \
    word("+ -") "mod(" exact() "," word("2 3 -2 1/2") ")+" word("round(k/2) round(-k/4) round(k+1/2) round(-k-1/2)")
}

function conditional(depth)
{
  if (random(3) == 1)
    return "(if " condition(1) " then " number(depth) " elseif " condition(1) " then " number(depth) \
      " else " number(depth) ")"
  return "(if " condition(1) " then " number(depth) " else " number(depth) ")"
}

# Infinity stands alone: Maxima looks without end for the sign of some powers of conditions where it stands in `or'.
function condition(depth,    kind)
{
  kind = random(depth ? 7 : 3)
  if (kind == 1)
    return arrays ? word("x=y x#y k=2 k#2 a=b y#x notequal(x,y) equal(y,x)") \
      : word("k=2 k#2 a=b a#b notequal(a,b) equal(k,2)")
  if (kind <= 3)
    return exact() word("< <= > >=") exact()
  if (kind == 4)
    return exact() word("< >") word("inf minf")
  if (kind == 5)
    return "not (" condition(depth - 1) ")"
  return "(" condition(depth - 1) (random(2) == 1 ? " and " : " or ") condition(depth - 1) ")"
}
