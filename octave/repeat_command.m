## -*- texinfo -*-
## @deftypefn {} {@var{command} =} repeat_command (@var{scene}, @var{options}, @var{make})
## What to type to run a @var{scene} again with the @var{options} (cell array) of @code{driver}: for the shell, or for
## Octave where the scene is a struct; @var{make} is the shell's command before the scene.
## @end deftypefn

function command = repeat_command (scene, options, make = "make simulate")
  if (isstruct (scene))
    words = cellfun (@(value) literal (value), options, "UniformOutput", false);
    command = ["driver (" strjoin([{"scene"}, words], ", ") ")"];
    return;
  endif
  command = [make " SCENE=" word(scene)];
  for pair = reshape (options(1:2*fix (end/2)), 2, [])
    command = [command, " ", toupper(pair{1}), "=", word(pair{2})];
  endfor
endfunction

function text = literal (value)
  if (ischar (value))
    text = ["\"" undo_string_escapes(value) "\""];
  else
    text = mat2str (value);
  endif
endfunction

function text = word (value)
  if (islogical (value) && isscalar (value))
    text = "no";
    if (value)
      text = "yes";
    endif
    return;
  elseif (isnumeric (value))
    value = strjoin (arrayfun (@(x) sprintf ("%.15g", x), value(:).', "UniformOutput", false), " ");
  elseif (! ischar (value))
    value = disp (value);
  endif
  text = value;
  if (isempty (value) || any (! (isalnum (value) | ismember (value, "_./-+"))))
    text = shell_string (value);
  endif
endfunction

%!assert (repeat_command ("paper", {}), "make simulate SCENE=paper")
%!assert (repeat_command ("my rod.m", {"modes", [7 7], "tolerance", 1e-6}), ...
%!        "make simulate SCENE='my rod.m' MODES='7 7' TOLERANCE=1e-06")
%!assert (repeat_command ("paper", {"at", "zoom=1"}, "make point"), "make point SCENE=paper AT='zoom=1'")
%!assert (repeat_command ("paper", {"pictures", false}), "make simulate SCENE=paper PICTURES=no")
%!assert (repeat_command (struct (), {"solver", "rk4", "modes", [1 2]}), ...
%!        "driver (scene, \"solver\", \"rk4\", \"modes\", [1 2])")
%!assert (repeat_command ("paper", {"pictures", true}), "make simulate SCENE=paper PICTURES=yes")
%!assert (repeat_command ("paper", {"output", ""}), "make simulate SCENE=paper OUTPUT=''")
%!assert (repeat_command (struct (), {"output", "a\nb", "modes"}), "driver (scene, \"output\", \"a\\nb\", \"modes\")")
