# Words for Maxima and paths of users, for the scripts of this folder.

maxima_string () {  # TEXT
  printf '"%s"' "$(printf '%s' "$1" | sed 's/[\\"]/\\&/g')"
}

user_path () {  # TEXT: as it was typed, with ~ for home and without a leading dash
  case $1 in
    "~"|"~/"*) printf '%s' "$HOME${1#"~"}" ;;
    -*) printf '%s' "./$1" ;;
    *) printf '%s' "$1" ;;
  esac
}
