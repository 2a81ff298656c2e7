# Read by a test that must not see a user's own settings: the worst of them, in the new folder $HOME. The test removes
# it.
HOME=$(mktemp -d)
mkdir "$HOME/.maxima"
echo 'fpprintprec: 5$ exptdispflag: false$ simp: false$' >"$HOME/.maxima/maxima-init.mac"
echo 'exit 1' >"$HOME/.maxima/maximarc"
echo 'error ("settings of the user are read");' >"$HOME/.octaverc"
echo 'exit status 1' >"$HOME/.gnuplot"
export HOME POSIXLY_CORRECT=1 MAXIMA_INITIAL_FOLDER=/ CDPATH="$HOME:/"
