# Translate a record of Maxima expressions into an Octave function:
#
#   gawk -f awk/maxima2octave.awk FILE.mx >FILE.m
#
# The status is 0 and the function is printed only if the whole record was translated; otherwise the status is 1 and
# standard error says `maxima2octave: file:line: message'.
#
# gawk looks for included files in AWKPATH but not beside the file that includes them. This file therefore starts
# gawk once more, with the same arguments, on translator.awk beside it, and in the C locale: a record is bytes. gawk
# must be itself, with POSIXLY_CORRECT not set.

function shell_quoted(text)
{
  gsub(/'/, "'\\''", text)
  return "'" text "'"
}

BEGIN {
  command = ""
  folder = "."
  for (position = 0; position in PROCINFO["argv"]; position++) {
    word = PROCINFO["argv"][position]
    if (word ~ /(^|\/)maxima2octave\.awk$/) {
      folder = word
      sub(/[^\/]*$/, ".", folder)
      word = "translator.awk"
    }
    command = command " " shell_quoted(word)
  }
  exit system("LC_ALL=C AWKPATH=" shell_quoted(folder) command) != 0
}
