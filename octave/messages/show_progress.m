## -*- texinfo -*-
## @deftypefn {} {} show_progress (@var{text})
## On a terminal, and only there, the line of progress, which the next one replaces; an empty @var{text} clears it.
## What has no room on the terminal's line is cut off, since no second line could be replaced.
## @end deftypefn

function show_progress (text)
  persistent shown = 0;
  if (on_terminal () && (shown > 0 || ! isempty (text)))
    room = terminal_size ()(2) - 1;
    if (room < 0)  # it is not known
      room = 79;
    endif
    text = text(1:min (end, room));
    printf ("\r%s\r%s", blanks (min (shown, room)), text);
    fflush (stdout);
    shown = numel (text);
  endif
endfunction

%!assert (evalc ("show_progress ('')"), "")
