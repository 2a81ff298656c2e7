## -*- texinfo -*-
## @deftypefn {} {@var{arguments} =} environment_options ()
## The arguments of @code{driver} from the environment, as `make simulate' passes them: SCENE, MODES, SOLVER, TOLERANCE and
## OUTPUT, those that are set and not empty.
## @end deftypefn

function arguments = environment_options ()
  scene = getenv ("SCENE");
  if (isempty (scene))
    scene = "paper";
  endif
  arguments = {scene};
  for name = {"MODES", "SOLVER", "TOLERANCE", "OUTPUT"}
    text = getenv (name{1});
    if (! isempty (text))
      arguments = [arguments, {tolower(name{1}), number_or_text(text)}];
    endif
  endfor
endfunction

## "7 7" and "1e-6" are numbers; names and folders are text
function value = number_or_text (text)
  [value, count, message, position] = sscanf (text, "%f");
  if (position <= numel (text) || isempty (value))
    value = text;
  else
    value = value.';
  endif
endfunction

%!test
%! unwind_protect
%!   setenv ("MODES", "0 4"); setenv ("TOLERANCE", "1e-6"); setenv ("OUTPUT", "a folder"); setenv ("SCENE", "");
%!   setenv ("SOLVER", "");
%!   assert (environment_options (), {"paper", "modes", [0 4], "tolerance", 1e-6, "output", "a folder"});
%! unwind_protect_cleanup
%!   cellfun (@(name) setenv (name, ""), {"MODES", "TOLERANCE", "OUTPUT"});
%! end_unwind_protect
