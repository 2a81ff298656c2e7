# For derive, derive_surface and write_equations, which have set command, folder and modes ("N1 N2") and read this
# file: a folder `aside' in `folder', gone at the end, and maxima_aside FILE STATEMENT OF to run Maxima with these
# modes, whose errors are said to be of the file OF, where it is stated.
# What it writes comes into `aside' and is moved out of there when whole: an interrupted command changes nothing, or
# leaves whole files. Maxima itself writes into a folder of a plain name: its Lisp takes others for patterns.
unset POSIXLY_CORRECT CDPATH  # where they are set gawk lacks arrays of arrays, and cd may print
here=$(cd "$(dirname "$0")" && pwd)
. "$here/strings.sh"

printf '%s\n' "$modes" | grep -Eqx '[0-9]{1,3} +[0-9]{1,3}' || {
  echo "$command: MODES is two numbers of modes, for instance MODES=\"7 7\", not \"$modes\"" >&2; exit 1; }

folder=$(user_path "$folder")
# Some Maximas compile their share library when they first use it.
export MAXIMA_SECONDS="${MAXIMA_SECONDS:-600}"

mkdir -p "$folder"
aside=$(mktemp -d "$folder/.$command-XXXXXX")
trap 'rm -rf "$aside"' EXIT
trap 'exit 1' INT TERM HUP
plain=$(mktemp -d)
trap 'rm -rf "$aside" "$plain"' EXIT

without_echo () {  # what Maxima says behind the statements that it repeats, in a line
  "${GAWK:-gawk}" '/exit_code *\(0\)/ { said = ""; next }
    { sub (/^SIMPLE-ERROR: /, ""); gsub (/[ \t]+/, " "); said = said (said == "" ? "" : " ") $0 }
    END { print said }'
}

maxima_aside () {
  mkdir "$plain/made"
  settings="modes: [$(printf '%s' "$modes" | sed 's/  */, /')]\$ output_folder: \"$plain/made\"\$"
  "$here/run" "$here/$1" "$settings ${2:-}" >"$plain/log" 2>&1 || {
    echo "$command: ${3:-Maxima failed}: $(tail -n 5 "$plain/log" | without_echo)" >&2; exit 1; }
  mv "$plain/made"/* "$aside"
}
