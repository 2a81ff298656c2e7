## -*- texinfo -*-
## @deftypefn {} {@var{arguments} =} environment_options (@var{more})
## The arguments of @code{driver} from the environment, as `make simulate' passes them: SCENE, MODES, SOLVER,
## TOLERANCE, SIZE ("1920x1080"), OUTPUT, PICTURES and EXACT (yes or no), PIECES, DENSE, BUDGET, TIME, FILM, and SPEEDS,
## FACTOR and FREQUENCIES (0:0.5:12), those that are set and not empty.  @var{more} (n-by-3 cell array, as of
## @code{take_fields}) has the names of others, and their kinds.
## @end deftypefn

function arguments = environment_options (more = cell (0, 3))
  scene = getenv ("SCENE");
  if (isempty (scene))
    scene = "paper";
  endif
  arguments = {scene};
  texts = [{"SOLVER", "OUTPUT"}, toupper(more(strcmp (more(:,3), "text"),1)).'];
  names = [{"MODES", "SOLVER", "TOLERANCE", "SIZE", "OUTPUT", "PICTURES", "DENSE", "EXACT", "PIECES", "BUDGET", "TIME", ...
            "FILM", "SPEEDS", "FACTOR", "FREQUENCIES"}, toupper(more(:,1)).'];
  for name = names
    value = getenv (name{1});
    if (! any (strcmp (name{1}, texts)))
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
    if (isempty (value))
      value = text;  # no numbers: what takes the option says so
    endif
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
%!   setenv ("AT", "1"); setenv ("KEEP", "yes");
%!   more = {"at", "", "text"; "keep", false, "true or false"};
%!   assert (environment_options (more)(end-3:end), {"at", "1", "keep", true});
%!   assert (any (strcmp (environment_options (), "keep")), false);
%!   setenv ("SPEEDS", "0:0.1:0.3");
%!   assert (environment_options (){end}, 0:0.1:0.3, 1e-15);
%!   for none = {"5:1:0", "0:0.1:-1", "0:0:0"}
%!     setenv ("SPEEDS", none{1}); assert (environment_options (){end}, none{1});  # is not left out
%!   endfor
%!   setenv ("SPEEDS", ""); setenv ("MODES", "7a");  # no number that begins well
%!   assert (environment_options ()(2:3), {"modes", "7a"});
%! unwind_protect_cleanup
%!   cellfun (@(name) setenv (name, ""), {"MODES", "TOLERANCE", "SIZE", "OUTPUT", "PICTURES", "SPEEDS", "AT", "KEEP"});
%! end_unwind_protect
