## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{folder}] =} take_options (@var{scene}, @var{folder}, @var{options})
## Put the options of @code{driver}, a cell array of names and values, into the scene's fields; "output" replaces
## @var{folder}.
## @end deftypefn

function [scene, folder] = take_options (scene, folder, options)
  if (mod (numel (options), 2) != 0)
    scene_error ("driver: options come as names and values, in pairs");
  endif
  fields = struct ("modes", {{"model", "modes"}}, "solver", {{"solver", "name"}}, ...
                   "tolerance", {{"solver", "tolerance"}}, "size", {{"frame_size"}});
  for pair = reshape (options, 2, [])
    [name, value] = pair{:};
    if (strcmp (name, "output") && ischar (value))
      folder = value;
    elseif (ischar (name) && isfield (fields, name))
      scene = setfield (scene, fields.(name){:}, value);
    else
      scene_error ("driver: \"%s\" is not an option: those are %s, output", disp_name (name), ...
                   strjoin (fieldnames (fields).', ", "));
    endif
  endfor
endfunction

function text = disp_name (name)
  text = strtrim (disp (name));
endfunction

%!test
%! [scene, folder] = take_options (struct (), "output/x", {"modes", [1 2], "output", "here"});
%! assert (scene.model.modes, [1 2]); assert (folder, "here");
%!error <in pairs> take_options (struct (), "", {"modes"})
