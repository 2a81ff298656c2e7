## -*- texinfo -*-
## @deftypefn {} {@var{text} =} point_message (@var{err})
## What is said of a point of a sweep that failed with the error @var{err}: its message in one line.  One of the
## interpreter's own, such as an index that is out of bound, is none of the point but of a program, and its text says
## of which, and in which line.
## @end deftypefn

function text = point_message (err)
  text = strjoin (strsplit (strtrim (err.message)), " ");
  if (strncmp (err.identifier, "Octave:", 7) && ! isempty (err.stack))
    text = sprintf ("an error in %s, line %d: %s", err.stack(1).name, err.stack(1).line, text);
  endif
endfunction

%!function text = of (varargin)
%!  try
%!    error (struct ("message", varargin{1}, "identifier", varargin{2}, ...
%!                   "stack", struct ("file", "", "name", "driven", "line", 7, "column", 1)));
%!  catch err
%!    text = point_message (err);
%!  end_try_catch
%!endfunction
%!assert (of ("index (0,_): out of bound\n", "Octave:index-out-of-bounds"), ...
%!        "an error in driven, line 7: index (0,_): out of bound")
%!assert (of ("rod.length is\n -1", "toolchain:scene"), "rod.length is -1")
%!assert (of ("no such rod", ""), "no such rod")   # what a scene's function says of its arguments
