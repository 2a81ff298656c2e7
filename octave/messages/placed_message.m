## -*- texinfo -*-
## @deftypefn {} {@var{text} =} placed_message (@var{err})
## What is said of an error @var{err} in a function of the user's, a scene's or a load's: its message in one line.  One
## of the interpreter's own, such as an index that is out of bound, says in which line of which file, where that is
## known: "brass.m, line 7: index (7): out of bound 3".
## @end deftypefn

function text = placed_message (err)
  text = strjoin (strsplit (strtrim (err.message)), " ");
  if (strncmp (err.identifier, "Octave:", 7))
    frame = user_frame (err.stack);
    if (! isempty (frame))
      [~, name, extension] = fileparts (frame.file);
      text = regexprep (text, ' near line \d+, column \d+$', "");
      text = sprintf ("%s%s, line %d: %s", name, extension, frame.line, text);
    endif
  endif
endfunction

## the innermost place in a file that is neither Octave's nor the program's, which has called it
function frame = user_frame (stack)
  program = fileparts (fileparts (mfilename ("fullpath")));
  within = @(folder) strncmp ({stack.file}, [folder filesep()], numel (folder) + 1);
  own = within (program) & ! within (fullfile (program, "scenes"));
  octaves = within (fullfile (OCTAVE_HOME (), "share", "octave"));
  known = [stack.line] > 0 & ! cellfun (@isempty, {stack.file});
  frame = stack(find (known & ! octaves & cumsum (own) == 0, 1));
endfunction

%!function text = of (message, identifier, varargin)
%!  frames = struct ("file", varargin(1:2:end), "name", "f", "line", varargin(2:2:end), "column", 1);
%!  try
%!    error (struct ("message", message, "identifier", identifier, "stack", frames(:)));
%!  catch err
%!    text = placed_message (err);
%!  end_try_catch
%!endfunction
%!shared program, octaves
%! program = fullfile (fileparts (fileparts (which ("placed_message"))), "run", "choose.m");
%! octaves = fullfile (OCTAVE_HOME (), "share", "octave", "m", "general", "interp1.m");
%!assert (of ("index (7):\n out of bound", "Octave:index-out-of-bounds", "/a/brass.m", 7, program, 3), ...
%!        "brass.m, line 7: index (7): out of bound")
%!assert (of ("'x' undefined near line 7, column 4", "Octave:undefined-function", "/a/my rod.m", 7), ...
%!        "my rod.m, line 7: 'x' undefined")
%!assert (of ("Invalid call", "Octave:invalid-fun-call", octaves, 90, "/a/brass.m", 7), ...
%!        "brass.m, line 7: Invalid call")
%!test # where there is no line, or the program itself has failed
%! assert (of ("no", "Octave:some-id", "/a/brass.m", -1, "", 4, program, 3, "/a/b.m", 5), "no");
%!assert (of ("no such\n rod", "", "/a/brass.m", 7), "no such rod")   # what a function itself says
