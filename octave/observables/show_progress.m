## -*- texinfo -*-
## @deftypefn {} {} show_progress (@var{text})
## On a terminal, and only there, the line of progress, which the next one replaces; an empty @var{text} clears it.
## @end deftypefn

function show_progress (text)
  persistent shown = false;
  if (on_terminal () && (shown || ! isempty (text)))
    printf ("\r%-70s\r%s", "", text);
    fflush (stdout);
    shown = ! isempty (text);
  endif
endfunction

%!assert (evalc ("show_progress ('')"), "")
