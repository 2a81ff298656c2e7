# gawk -f calls.awk FILES: the calls among these Octave files, which are known by their names, and within them. A line
# each, with tabs between: the calling file, the function in it, the line, the called file, the function in it, and the
# texts of the arguments with \v between, "@" of a handle.
#
# A call is a name, but for fields and what a function has as a variable: an argument, a result, what it assigns.
# Comments, strings and tests are passed over.

BEGIN {
  for (i = 1; i < ARGC; i++)
    path[gensub(/.*\/|\.m$/, "", "g", ARGV[i])] = ARGV[i]
  transposed = "[A-Za-z0-9_)\\]}.]'"
  passed_over = "\"(\\\\.|[^\"\\\\])*\"|'[^']*'|([#%]|\\.\\.\\.).*"
  mention = "(^|[^A-Za-z0-9_.])(@?)([A-Za-z]\\w*)( *\\()?"
  anonymous = "@ *\\([^()]*\\)"
  several = "\\[[^]=[]*\\] *=[^=]"
  begins = "(^|[\n;]) *((par)?for *)?\\(?"
  assigned = begins "[A-Za-z]\\w*( *[-+*/|&.]*=|[({.][^=\n;]*[^=<>!~]=)[^=]"
}

BEGINFILE {
  split("", own)
  functions = 0
  if (FILENAME ~ /^generated/) nextfile   # these call nothing
  begin_function("")   # what stands outside of functions: a script
}

/^function/ { begin_function(name_of($0)) }

! /^%!/ {
  text[functions] = text[functions] $0 "\n"
  code[functions] = code[functions] blanked($0) "\n"
}

ENDFILE {
  for (k = 1; k <= functions; k++)
    list_calls(k)
}

function begin_function(name) {
  own[name]
  caller[++functions] = name
  first[functions] = name == "" ? 1 : FNR
  text[functions] = code[functions] = ""
}

# the name in a line that begins a function
function name_of(line,    found) {
  match(line, /(function|=) *([A-Za-z]\w*) *(\(|$)/, found)
  return found[2]
}

# the line with blanks for strings and comments, of the same length
function blanked(line,    done, kept) {
  while (match(line, transposed "|" passed_over)) {
    kept = substr(line, RSTART, RLENGTH) ~ "^" transposed "$" ? RLENGTH : 0
    done = done substr(line, 1, RSTART - 1 + kept) sprintf("%*s", RLENGTH - kept, "")
    line = substr(line, RSTART + RLENGTH)
  }
  return done line
}

function list_calls(k,    name, file, at, behind, found) {
  find_variables(code[k])
  if (match(code[k], /^function[^(\n]*/)) at = RLENGTH
  while (match(substr(code[k], at + 1), mention, found)) {
    name = found[3]
    behind = at + found[3, "start"] + found[3, "length"]
    file = name in own ? FILENAME : path[name]
    if (file != "" && ! (name in variable))
      print FILENAME "\t" caller[k] "\t" line_of(k, behind) "\t" file "\t" name "\t" \
        (found[2] ? "@" : found[4] ? inside(k, at + RSTART + RLENGTH) : "")
    at = behind - 1
  }
}

function line_of(k, place,    before) {
  before = substr(code[k], 1, place - 1)
  return first[k] + gsub(/\n/, "", before)
}

# the text in a parenthesis from its first place on, in one line, with \v for its own commas
function inside(k, from,    depth, i, c, result) {
  for (i = from; i <= length(code[k]); i++) {
    c = substr(code[k], i, 1)
    depth += (c ~ /[(\[{]/) - (c ~ /[)\]}]/)
    if (depth < 0) break
    result = result (c == "," && depth == 0 ? "\v" : substr(text[k], i, 1))
  }
  return gensub(/ *(\.\.\.)?\n */, " ", "g", result)
}

function find_variables(code,    found) {
  split("", variable)
  if (match(code, /^function[^\n(]*(\([^)]*\))?/))
    add_names(gensub(/\w+ *\(/, "", "g", substr(code, 1, RLENGTH)))   # no call of a default value
  while (match(code, anonymous "|" several "|" assigned)) {
    found = substr(code, RSTART, RLENGTH)
    code = substr(code, RSTART + RLENGTH - 1)
    add_names(found ~ /^[@[]/ ? found : gensub(begins "([A-Za-z]\\w*).*", "\\4", 1, found))
  }
}

function add_names(text) {
  gsub(/\.[A-Za-z]\w*/, "", text)   # fields
  while (match(text, /[A-Za-z]\w*/)) {
    variable[substr(text, RSTART, RLENGTH)]
    text = substr(text, RSTART + RLENGTH)
  }
}
