# Structures. Arguments `structure.field' with one structure are one argument of the function, a struct. The body
# mentions the field by its own name; the function takes it out of the struct before anything else.
#
#   argument_structure[k]                         structure of argument k, "" if it has none
#   parameter_count, parameter[i]                 Octave names of what the function takes, in the order of appearance
#   argument_label[k]                             how the caller knows the argument: `name' or `structure.name'

BEGIN {
  parameter_count = 0
}

# The record's text of an argument less its structure, which becomes that of argument k.
function take_structure(k, text,    name)
{
  argument_structure[k] = ""
  if (!match(text, /^[A-Za-z][A-Za-z0-9_]*[.]/))
    return text
  name = substr(text, 1, RLENGTH - 1)
  text = substr(text, RLENGTH + 1)
  if (text !~ /^[A-Za-z][A-Za-z0-9_]* /)
    fail("`" substr(text, 1, index(text " ", " ") - 1) "' cannot be a field of the structure " name)
  if (name in is_listed && !(name in is_structure))
    fail("the name " name " is used twice")
  argument_structure[k] = name
  is_listed[name] = is_structure[name] = 1
  return text
}

# The Octave names of argument k and of its structure.
function name_argument(k,    name)
{
  name = argument_structure[k]
  if (name != "" && !(name in structure_octave))
    parameter[++parameter_count] = structure_octave[name] = octave_name(name)
  argument_octave[k] = octave_name(argument_name[k])
  if (name == "")
    parameter[++parameter_count] = argument_octave[k]
  argument_label[k] = name == "" ? argument_octave[k] : structure_octave[name] "." argument_name[k]
}

# `mass = rod.mass;'
function put_fields(    k)
{
  for (k = 1; k <= argument_count; k++)
    if (argument_structure[k] != "")
      put("  " argument_octave[k] " = " argument_label[k] ";")
}
