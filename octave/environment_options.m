## -*- texinfo -*-
## @deftypefn {} {@var{arguments} =} environment_options ()
## The arguments of @code{driver} from the environment, as `make simulate' passes them: SCENE, MODES, SOLVER,
## TOLERANCE, SIZE ("1920x1080"), OUTPUT, PICTURES (yes or no), DENSE, BUDGET, TIME, FILM, and SPEEDS, FACTOR and FREQUENCIES
## (0:0.5:12), those that are set and not empty.
## @end deftypefn

function arguments = environment_options ()
  scene = getenv ("SCENE");
  if (isempty (scene))
    scene = "paper";
  endif
  arguments = {scene};
  for name = {"MODES", "SOLVER", "TOLERANCE", "SIZE", "OUTPUT", "PICTURES", "DENSE", "BUDGET", "TIME", "FILM", "SPEEDS", ...
              "FACTOR", "FREQUENCIES"}
    value = getenv (name{1});
    if (! any (strcmp (name{1}, {"SOLVER", "OUTPUT"})))
      value = number_or_text (value);
    endif
    if (! isempty (value))
      arguments = [arguments, {tolower(name{1}), value}];
    endif
  endfor
endfunction

## "7 7", "1920x1080", "0:0.5:12" and "1e-6" are numbers, yes and no are true and false
function value = number_or_text (text)
  range = str2double (strsplit (text, ":"));
  if (numel (range) == 3 && all (isfinite (range)))
    value = range(1):range(2):range(3)*(1 + eps);
    return;
  endif
  if (any (strcmpi (text, {"yes", "no"})))
    value = strcmpi (text, "yes");
    return;
  endif
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
%!   setenv ("SOLVER", ""); setenv ("SIZE", "640x360"); setenv ("PICTURES", "no");
%!   assert (environment_options (), {"paper", "modes", [0 4], "tolerance", 1e-6, "size", [640 360], ...
%!                                    "output", "a folder", "pictures", false});
%!   setenv ("OUTPUT", "2024");
%!   assert (environment_options (){end-2}, "2024");  # a folder
%!   setenv ("SPEEDS", "0:0.1:0.3");
%!   assert (environment_options (){end}, 0:0.1:0.3, 1e-15);
%! unwind_protect_cleanup
%!   cellfun (@(name) setenv (name, ""), {"MODES", "TOLERANCE", "SIZE", "OUTPUT", "PICTURES", "SPEEDS"});
%! end_unwind_protect
