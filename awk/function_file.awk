# The generated file as a whole. Its body is printed first, since the banner counts the operations.

function print_function_file(    body, body_count, k)
{
  for (k = 1; k <= statement_count; k++)
    put_assignment(statement_name[k], statement_value[k])
  for (k = 1; k <= result_count; k++)
    put_assignment(result_octave[k], result_value[k])
  body_count = output_count
  for (k = 1; k <= body_count; k++)
    body[k] = output[k]
  output_count = 0

  put_head(operation_summary())
  put_signature()
  put_checks()
  for (k = 1; k <= body_count; k++)
    put(body[k])
  put("endfunction")
  put_local_functions()
  for (k = 1; k <= output_count; k++)
    print output[k]
}

# function [tension, moment] = name (x, t)
function put_signature(    k)
{
  emit("function " (result_count > 1 ? "[" : ""))
  for (k = 1; k <= result_count; k++)
    emit(result_octave[k] (k < result_count ? ", " : result_count > 1 ? "] = " : " = "))
  emit(record["function"] " (")
  for (k = 1; k <= parameter_count; k++)
    emit(parameter[k] (k < parameter_count ? ", " : ""))
  emit(")")
  put_pieces()
}
