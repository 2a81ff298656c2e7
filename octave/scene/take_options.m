## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{output}] =} take_options (@var{scene}, @var{folder}, @var{options})
## Put the options of @code{driver}, a cell array of names and values, into the scene's fields, and those that say what
## is written into the struct @var{output}: its @code{folder} (@var{folder}, unless the option "output" replaces it; ""
## writes nothing), whether there are @code{pictures} (true, unless the option is false), how many times a second (1/s)
## a @code{dense} table has, [] for none, the @code{command} that the summary has, "" for the call itself, and whether
## the model is to be @code{exact} (see exactly in @code{kind_of}; "auto": where others cannot hold the tolerance).
## @end deftypefn

function [scene, output] = take_options (scene, folder, options)
  output = struct ("folder", folder, "pictures", true, "dense", [], "command", "", "exact", []);
  if (mod (numel (options), 2) != 0)
    scene_error ("options come as names and values, in pairs");
  endif
  fields = struct ("modes", {{"model", "modes"}}, "solver", {{"solver", "name"}}, ...
                   "tolerance", {{"solver", "tolerance"}}, "size", {{"frame_size"}}, "pieces", {{"pieces"}});
  for pair = reshape (options, 2, [])
    [name, value] = pair{:};
    if (any (strcmp (name, {"output", "command"})) && ! ischar (value))
      scene_error ("%s is %s: it takes a text", name, disp_name (value));
    elseif (strcmp (name, "output"))
      output.folder = user_path (value);
    elseif (strcmp (name, "exact") && strcmp (value, "auto"))
      output.exact = "auto";
    elseif (any (strcmp (name, {"pictures", "exact"})))
      if (! ((islogical (value) || isnumeric (value)) && isscalar (value) && any (value == [0 1])))
        scene_error ("%s is %s: it takes true or false, %s=yes or no", name, disp_name (value), toupper (name));
      endif
      output.(name) = logical (value);
    elseif (strcmp (name, "dense"))
      if (! (isnumeric (value) && isscalar (value) && value > 0 && isfinite (value)))
        scene_error ("dense is %s: it takes a positive number, of times a second", disp_name (value));
      endif
      output.dense = value;
    elseif (strcmp (name, "command"))
      output.command = value;
    elseif (ischar (name) && isfield (fields, name))
      scene = with_field (scene, fields.(name), value);
    else
      scene_error (["\"%s\" is not an option: those are %s, output, pictures, dense, exact, command, and of each" ...
                    " study what `make help' says"], disp_name (name), strjoin (fieldnames (fields).', ", "));
    endif
  endfor
  modes = options(2:2:end)(strcmp (options(1:2:end), "modes"));
  if (isequal (output.exact, true) && ! isempty (modes) && ! strcmp (modes{end}, "auto"))
    scene_error ("exact and modes are both given: the exact rod takes as many polynomials as it needs");
  endif
endfunction

## left as it is where the scene has no struct for it, which its check tells
function scene = with_field (scene, path, value)
  parent = field_or (scene, path{1}, struct ());
  if (isscalar (path) || (isstruct (parent) && isscalar (parent)))
    scene = setfield (scene, path{:}, value);
  endif
endfunction

function text = disp_name (name)
  text = strtrim (disp (name));
endfunction

%!test
%! [scene, output] = take_options (struct (), "output/x", {"modes", [1 2], "output", "here"});
%! assert (scene.model.modes, [1 2]);
%! assert (output, struct ("folder", "here", "pictures", true, "dense", [], "command", "", "exact", []));
%! assert (nthargout (2, @take_options, scene, "here", {"command", "make"}).command, "make");
%! assert (nthargout (2, @take_options, scene, "here", {"dense", 1e3}).dense, 1e3);
%! assert (nthargout (2, @take_options, scene, "here", {"pictures", false}).pictures, false);
%! assert (nthargout (2, @take_options, scene, "here", {"pictures", 1}).pictures, true);
%!test # what is no struct is left to the check
%! assert (take_options (struct ("model", 3), "", {"modes", "auto", "exact", true}).model, 3);
%! assert (size (take_options (struct ("solver", {struct("step", {1; 2})}), "", {"tolerance", 1}).solver), [2 1]);
%!assert (nthargout (2, @take_options, struct (), "", {"output", "-x"}).folder, "./-x")
%!error <pictures is maybe: it takes true or false, PICTURES=yes or no>
%! take_options (struct (), "", {"pictures", "maybe"});
%!error <dense is -1: it takes a positive number, of times a second> take_options (struct (), "", {"dense", -1});
%!error <exact is 3: it takes true or false, EXACT=yes or no> take_options (struct (), "", {"exact", 3});
%!assert (nthargout (2, @take_options, struct (), "", {"exact", "auto"}).exact, "auto")
%!error <output is 3: it takes a text> take_options (struct (), "", {"output", 3});
%!error <command is 3: it takes a text> take_options (struct (), "", {"command", 3});
%!error <"film" is not an option: those are .*, command, and of each study what `make help' says>
%! take_options (struct (), "", {"film", 3});
%!error <in pairs> take_options (struct (), "", {"modes"})
%!error <pictures is 2: it takes> take_options (struct (), "", {"pictures", 2});
%!error <exact and modes are both given: the exact rod takes as many polynomials as it needs>
%! take_options (struct (), "", {"modes", [7 7], "exact", true});
%!assert (nthargout (2, @take_options, struct (), "", {"modes", "auto", "exact", true}).exact, true)
