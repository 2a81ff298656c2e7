## -*- texinfo -*-
## @deftypefn {} {[@var{file}, @var{numbers}, @var{typed}] =} find_scene (@var{which})
## The function @var{file} of a scene by what @code{load_scene} takes, a name or a path, the @var{numbers} in
## parentheses behind it (cell array), and what is to be @var{typed} for the same in any folder.
## @end deftypefn

function [file, numbers, typed] = find_scene (which)
  if (! (ischar (which) && rows (which) == 1))
    scene_error ("a scene is a name, a path or a struct, not a %s", class (which));
  endif
  shipped = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes");
  [file, numbers] = file_and_numbers (which, shipped);
  if (isempty (file))
    names = regexp (readdir (shipped), '^\w+(?=\.m$)', "match", "once");
    names = names(! cellfun (@isempty, names)).';
    scene_error ("no scene \"%s\": it is one of %s, or the path of a function file", which, strjoin (names, ", "));
  endif
  [folder, name] = fileparts (file);
  typed = file;
  if (strcmp (folder, shipped))
    typed = name;
  endif
  if (! isempty (numbers))
    typed = sprintf ("%s(%s)", typed, sprintf (",%.17g", numbers{:})(2:end));
  endif
endfunction

## A path may hold parentheses: only what is no file is a name with numbers.
function [file, numbers] = file_and_numbers (text, shipped)
  numbers = {};
  file = file_of (text, shipped);
  call = regexp (text, '^(.*?)\s*\(([^()]*)\)$', "tokens", "once");
  if (isempty (file) && ! isempty (call))
    file = file_of (call{1}, shipped);
    given = strsplit (call{2}, ",")(1:end*! isempty (strtrim (call{2})));
    numbers = cellfun (@str2double, given, "uniformoutput", false);
    if (any (cellfun (@isnan, numbers)) && ! isempty (file))
      scene_error ("%s: what is within the parentheses is \"%s\", it takes numbers", text, call{2});
    endif
  endif
endfunction

## The absolute path of a scene's file, "" if there is none. A name alone is one of the shipped.
function file = file_of (text, shipped)
  [folder, name, extension] = fileparts (text);
  if (isempty (folder) && isempty (extension))
    folder = shipped;
  endif
  file = make_absolute_filename (fullfile (user_path (folder), [name ".m"]));
  if (exist (file, "file") != 2 || ! any (strcmp (extension, {"", ".m"})))
    file = "";
  endif
endfunction

%!test
%! [file, numbers, typed] = find_scene ("chain( 20 )");
%! assert (file, which ("chain")); assert (numbers, {20}); assert (typed, "chain(20)");
%! assert (nthargout (2:3, @find_scene, "paper"), {{}, "paper"});
%!error <no scene "nowhere": it is one of arc_pendulum, .*paper,.*two_link_arm> find_scene ("nowhere")
%!error <chain\(twenty\): what is within the parentheses is "twenty", it takes numbers> find_scene ("chain(twenty)")
%!error <a scene is a name, a path or a struct, not a double> find_scene (3)
