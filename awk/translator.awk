# The translator: read the record, parse its body, and print the Octave function once nothing more can go wrong.

@include "record.awk"
@include "variables.awk"
@include "names.awk"
@include "lexer.awk"
@include "numbers.awk"
@include "functions.awk"
@include "shapes.awk"
@include "nodes.awk"
@include "parser.awk"
@include "atoms.awk"
@include "lists.awk"
@include "body.awk"
@include "results.awk"
@include "printer.awk"
@include "infix.awk"
@include "lines.awk"
@include "docstring.awk"
@include "size_check.awk"
@include "close_look.awk"
@include "function_file.awk"

BEGIN {
  if (ARGC != 2) {
    print "usage: gawk -f awk/maxima2octave.awk FILE.mx >FILE.m" >"/dev/stderr"
    exit 1
  }
  read_record(ARGV[1])
  parse_body(record["body"])
  print_function_file()
}
