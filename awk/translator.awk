# The translator: read the record, parse its body, and print the Octave function once nothing more can go wrong.

@include "record.awk"
@include "structures.awk"
@include "variables.awk"
@include "names.awk"
@include "lexer.awk"
@include "numbers.awk"
@include "functions.awk"
@include "shapes.awk"
@include "kinds.awk"
@include "nodes.awk"
@include "fractions.awk"
@include "powers.awk"
@include "parser.awk"
@include "atoms.awk"
@include "calls.awk"
@include "sums.awk"
@include "lists.awk"
@include "body.awk"
@include "results.awk"
@include "printer.awk"
@include "infix.awk"
@include "lines.awk"
@include "docstring.awk"
@include "size_check.awk"
@include "close_look.awk"
@include "local_functions.awk"
@include "function_file.awk"

BEGIN {
  if (ARGC != 2) {
    print "usage: gawk -f awk/maxima2octave.awk FILE.mx >FILE.m" >"/dev/stderr"
    exit 1
  }
  read_record(ARGV[1])
  cut_into_tokens(record["body"])
  reserve_called_functions()
  name_arguments_and_results()
  parse_body()
  print_function_file()
}
