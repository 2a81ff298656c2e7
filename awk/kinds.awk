# Numbers and conditions are never mixed.

function check_kind(id, operator)
{
  if (operator == "and" || operator == "or")
    must_be_condition(id, operator)
  else
    must_be_number(id, operator)
}

function must_be_number(id, operator)
{
  if (node_truth[id])
    fail("`" operator "' wants a number, not a condition")
}

function must_be_condition(id, operator)
{
  if (!node_truth[id])
    fail("`" operator "' wants a condition, not a number")
}
