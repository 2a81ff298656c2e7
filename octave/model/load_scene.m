## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{name}] =} load_scene (@var{which})
## The scene of a function in octave/scenes/, by its name, or of a function file of one's own, by its path.
## A struct is taken as it is; "chain(20)" calls the function with the number.
## @end deftypefn

function [scene, name] = load_scene (which)
  shipped = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes");
  if (isstruct (which))
    [scene, name] = deal (which, "scene");
    return;
  elseif (! (ischar (which) && rows (which) == 1))
    scene_error ("a scene is a name, a path or a struct, not a %s", class (which));
  endif
  [which, number] = strtok (which, "(");  # SCENE="chain(20)"
  number = sscanf (number, "(%f)");
  [folder, name, extension] = fileparts (which);
  if (isempty (folder))
    folder = shipped;
    if (! isempty (extension))
      folder = pwd ();
    endif
  endif
  file = fullfile (make_absolute_filename (folder), [name ".m"]);
  if (! exist (file, "file") || ! any (strcmp (extension, {"", ".m"})))
    names = regexprep (glob (fullfile (shipped, "*.m")).', '.*[/\\](\w+)\.m$', '$1');
    scene_error ("no scene \"%s\": it is one of %s, or the path of a function file", which, strjoin (names, ", "));
  elseif (! isvarname (name))
    scene_error ("the scene's file %s needs the name of a function", file);
  endif
  scene = evaluate (file, name, num2cell (number));
endfunction

function scene = evaluate (file, name, arguments)
  before = path ();
  unwind_protect
    addpath (fileparts (file));
    clear (name);
    scene = feval (name, arguments{:});
  unwind_protect_cleanup
    path (before);
  end_unwind_protect
endfunction

%!assert (load_scene ("paper").duration, 1.8)
%!assert (numel (load_scene ("chain(3)").bodies), 3)
%!error <no scene "nowhere": it is one of arc_pendulum, .*paper,.*two_link_arm> load_scene ("nowhere")
%!error <a scene is a name, a path or a struct, not a double> load_scene (3)
%!test # a file of one's own, in a folder with a space
%! folder = tempname (); mkdir (folder); own = fullfile (folder, "own scene"); mkdir (own);
%! unwind_protect
%!   fid = fopen (fullfile (own, "my_rod.m"), "w");
%!   fputs (fid, "function s = my_rod ()\n s.duration = 4;\nend\n"); fclose (fid);
%!   [scene, name] = load_scene (fullfile (own, "my_rod.m"));
%!   assert (scene.duration, 4); assert (name, "my_rod");
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local"); rmdir (folder, "s");
%! end_unwind_protect
