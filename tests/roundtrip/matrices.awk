# Random expressions for columns, matrices, and numbers made of them. No factor of a matrix is 0, and no terms of a sum
# of columns cancel, since no other factor is 17/19: Maxima would make a number of such a product, or sum.

function scalar_of_matrices(depth,    kind)
{
  kind = random(3)
  if (kind == 1)
    return "dot(" column(depth) "," column(depth) ")"
  return kind == 2 ? "(transpose(V) . (" column(depth) "))" : "(transpose(W) . M . V)"
}

function column(depth,    kind)
{
  if (depth <= 0)
    return word("V W")
  kind = random(9)
  if (kind <= 2) return column(depth - 1) word("+17/19* -17/19*k* *") column(depth - 1)
  if (kind == 3) return "(" scalar(0) ")*(" column(depth - 1) ")"
  if (kind == 4) return "M . (" column(depth - 1) ")"
  if (kind == 5) return word("-V V/W W^2 2^V V^k sin(V) W+a k-V V/3 3/(1+V)")
  if (kind == 6) return "(if " scalar_condition() " then " column(depth - 1) " else W)"
  if (kind == 8) return "M^^" word("2 3 k -k -1 (k+1)") " . (" column(depth - 1) ")"
  if (kind == 7) return "(M+transpose(M)) . W*2"
  return "transpose(transpose(V) . M)"
}

function square(depth,    kind)
{
  kind = random(8)
  if (kind == 7) return "-M^^" word("2 -1 -2 k") word("+ - *") "transpose(M)^^" word("-1 2 (1-k)")
  if (kind == 8) return "M^" word("(1/3) (2/3) (k/3)") "*" leaf() "+M"
  if (kind == 1) return "V . transpose(" column(depth) ")"
  if (kind == 2) return "transpose(M) . M . M"
  if (kind == 3) return "(1/7+" scalar(1) ")*M" word("+ - *") "transpose(M)"
  if (kind == 4) return "M" word("^2 ^-1 /2 *M +a")
  if (kind == 5) return "-M . transpose(M)+" word("1 a k") "*M"
  return "M-2*transpose(M)"
}

function two_by_three(    kind)
{
  return word("1 2 a") "*R" word("+ - *") "matrix([" scalar(1) "," scalar(0) ",-a],[-1," scalar(1) "," leaf() "-a])"
}

function scalar(depth,    before, text)
{
  before = arrays
  arrays = 0
  text = number(depth)
  arrays = before
  return text
}

function scalar_condition(    before, text)
{
  before = arrays
  arrays = 0
  text = condition(1)
  arrays = before
  return text
}
