## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} on_terminal ()
## Whether a person watches at a terminal, who wants to see progress: output goes there, and the environment has no
## QUIET.
## @end deftypefn

function yes = on_terminal ()
  persistent terminal = system ("test -t 1") == 0;
  yes = terminal && any (strcmp (getenv ("QUIET"), {"", "0"}));
endfunction

%!assert (isscalar (on_terminal ()) && islogical (on_terminal ()))
