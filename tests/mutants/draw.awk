# gawk -f draw.awk FILES: all mutations that can be made, a line each: file, what its line was, what it becomes, the
# line's number, with tabs between them.
#
# Comments, strings, tests and regular expressions stay as they are. A mutation takes another operator, adds 1 to a
# number or an index (more to one above 9), or drops a statement.

BEGIN {
  split("<= < >= > == != && || .* ./ += -= ++ --", of_two)
  for (i = 1; i in of_two; i += 2) {
    other[of_two[i]] = of_two[i + 1]
    other[of_two[i + 1]] = of_two[i]
  }
  other["+"] = "-"; other["-"] = "+"; other["*"] = "/"; other["/"] = "*"
}

FNR == 1 {
  kind = gensub(/.*\./, "", 1, FILENAME)
  comment = 0
}

{
  code = without_text($0)
  if (kind == "m" && code !~ /^ /) next   # signatures, tests and what stands outside of functions
  if (kind == "mac" && FILENAME !~ /print/ && code ~ /^(declare|assume|load|matchdeclare)/) next
  find_operators(code)
  find_numbers(code)
  if (code ~ statement()) add(gensub(/[^ ].*/, dropped(), 1))
}

# the line with blanks for strings and comments; of Maxima's, comments may go on
function without_text(line,    result, i, c, before, quote) {
  for (i = 1; i <= length(line); i++) {
    c = substr(line, i, 1)
    if (comment) {
      if (substr(line, i, 2) == "*/") { comment = 0; result = result " "; i++ }
      c = " "
    } else if (quote != "") {
      if (c == "\\" && quote != "'") { result = result " "; i++ } else if (c == quote) quote = ""
      c = " "
    } else if (kind == "mac" && substr(line, i, 2) == "/*") {
      comment = 1; result = result " "; i++; c = " "
    } else if (kind != "mac" && (c == "#" || (kind == "m" && c == "%"))) {
      break
    } else if (c == "\"" || (kind == "m" && c == "'" && before !~ /[A-Za-z0-9_)\]}.']/) \
               || (kind == "awk" && c == "/" && before ~ /^[(~,!]?$/)) {
      quote = c; c = " "
    }
    if (c != " ") before = c
    result = result c
  }
  return sprintf("%-" length(line) "s", result)
}

function find_operators(code,    i, two, one) {
  for (i = 1; i <= length(code); i++) {
    two = substr(code, i, 2); one = substr(code, i, 1)
    if (two in other) {
      replace(i, 2, other[two]); i++
    } else if (two ~ /^([.'=!~^:-]=|\.['^]|=[>])$/ || substr(code, i, 3) ~ /^\.\.\.$/) {
      i++
    } else if (one in other && substr(code, i - 1, 2) !~ /^[eE@(][-+*]$/ && ! (kind == "awk" && one == "/")) {
      replace(i, 1, other[one])
    } else if (one ~ /[<>]/ && kind != "awk") {
      replace(i, 1, other[one])
    }
  }
}

function find_numbers(code,    at, rest) {
  at = 0
  while (match(rest = substr(code, at + 1), /[0-9]+/)) {
    if (substr(code, at + RSTART - 1, 1) !~ /[A-Za-z0-9_.%]/ && substr(code, 1, at + RSTART - 1) !~ /[0-9][eE][-+]$/ \
        && substr(code, at + RSTART + RLENGTH, 1) !~ /[0-9.eE]/)
      replace(at + RSTART, RLENGTH, another(substr(rest, RSTART, RLENGTH)))
    at += RSTART + RLENGTH - 1
  }
}

function another(number) {
  return number < 10 ? number + 1 : 10 * number
}

# a statement that has a line of its own
function statement() {
  if (kind == "m") return "^ +[a-z][a-zA-Z0-9_.(),:]* *([-+*/]?=[^=].*|\\(.*\\)|\\+\\+|--);$"
  if (kind == "awk") return "^ +[a-z][a-zA-Z0-9_, \\[\\]]*([-+]?= [^|&?{]*|\\([^{]*\\)|\\+\\+)$"
  return "^ +[a-z][a-zA-Z0-9_]*: .*,$"
}

function dropped() {
  return kind == "awk" ? ";" : ""
}

function replace(at, size, by) {
  add(substr($0, 1, at - 1) by substr($0, at + size))
}

function add(line) {
  if (line != $0) print FILENAME "\t" $0 "\t" line "\t" FNR
}
