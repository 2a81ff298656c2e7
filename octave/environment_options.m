## -*- texinfo -*-
## @deftypefn {} {@var{arguments} =} environment_options ()
## The arguments of @code{driver} from the environment, as `make simulate' passes them: SCENE, MODES, SOLVER,
## TOLERANCE, SIZE ("1920x1080") and OUTPUT, those that are set and not empty.
## @end deftypefn

function arguments = environment_options ()
  scene = getenv ("SCENE");
  if (isempty (scene))
    scene = "paper";
  endif
  arguments = {scene};
  for name = {"MODES", "SOLVER", "TOLERANCE", "SIZE", "OUTPUT"}
    text = getenv (name{1});
    if (! isempty (text))
      arguments = [arguments, {tolower(name{1}), number_or_text(text)}];
    endif
  endfor
endfunction

## "7 7", "1920x1080" and "1e-6" are numbers; names and folders are text
function value = number_or_text (text)
  [value, count, message, position] = sscanf (regexprep (text, '^(\d+)x(\d+)$', '$1 $2'), "%f");
  if (position <= numel (text) || isempty (value))
    value = text;
  else
    value = value.';
  endif
endfunction

%!test
%! unwind_protect
%!   setenv ("MODES", "0 4"); setenv ("TOLERANCE", "1e-6"); setenv ("OUTPUT", "a folder"); setenv ("SCENE", "");
%!   setenv ("SOLVER", ""); setenv ("SIZE", "640x360");
%!   assert (environment_options (), {"paper", "modes", [0 4], "tolerance", 1e-6, "size", [640 360], ...
%!                                    "output", "a folder"});
%! unwind_protect_cleanup
%!   cellfun (@(name) setenv (name, ""), {"MODES", "TOLERANCE", "SIZE", "OUTPUT"});
%! end_unwind_protect
