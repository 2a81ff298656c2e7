# For derive and write_equations, which have set command, folder and modes ("N1 N2") and read this file: a folder
# `aside' in `folder', gone at the end, and maxima_aside FILE STATEMENT to run Maxima with these modes. What it makes
# there is moved out when whole: an interrupted command changes nothing, or leaves whole files.
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

maxima_aside () {
  "$here/run" "$here/$1" "modes: [$(printf '%s' "$modes" | sed 's/  */, /')]\$ $2" >"$aside/log" 2>&1 || {
    echo "$command: Maxima failed:" >&2; tail -n 5 "$aside/log" >&2; exit 1; }
}
