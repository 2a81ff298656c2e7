## -*- texinfo -*-
## @deftypefn {} {@var{text} =} point_message (@var{err})
## What is said of a point of a sweep that failed with the error @var{err}: its message in one line.  One of the
## interpreter's own, such as an index that is out of bound, is none of the point but of a program, and its text says
## of which, and in which line.
## @end deftypefn

function text = point_message (err)
  text = strjoin (strsplit (strtrim (err.message)), " ");
  if (strncmp (err.identifier, "Octave:", 7) && ! isempty (err.stack))
    place = err.stack(1).name;
    if (err.stack(1).line > 0)
      place = sprintf ("%s, line %d", place, err.stack(1).line);
    endif
    text = sprintf ("an error in %s: %s", place, text);
  endif
endfunction

%!function text = of (message, identifier, line = 7)
%!  try
%!    error (struct ("message", message, "identifier", identifier, ...
%!                   "stack", struct ("file", "", "name", "driven", "line", line, "column", 1)));
%!  catch err
%!    text = point_message (err);
%!  end_try_catch
%!endfunction
%!assert (of ("index (0,_): out of bound\n", "Octave:index-out-of-bounds"), ...
%!        "an error in driven, line 7: index (0,_): out of bound")
%!assert (of ("no", "Octave:some-id", -1), "an error in driven: no")   # no line is known
%!assert (of ("rod.length is\n -1", "toolchain:scene"), "rod.length is -1")
%!assert (of ("no such rod", ""), "no such rod")   # what a scene's function says of its arguments
