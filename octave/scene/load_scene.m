## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{name}] =} load_scene (@var{which}, @var{arguments})
## The scene of a function in octave/scenes/, by its name, or of a function file of one's own, by its path, which may
## hold anything.  A struct is taken as it is; "chain(20)" calls the function with the number.  Those of the
## @var{arguments} (cell array) that are not empty come in the place of such numbers.
## @end deftypefn

function [scene, name] = load_scene (which, arguments = {})
  if (isstruct (which))
    [scene, name] = deal (which, "scene");
    return;
  endif
  [file, numbers] = find_scene (which);
  [~, name] = fileparts (file);
  scene = evaluate (file, with_arguments (numbers, arguments, which));
endfunction

function numbers = with_arguments (numbers, arguments, which)
  stated = find (! cellfun (@isempty, arguments));
  numbers(stated) = arguments(stated);
  left_out = find (cellfun (@isempty, numbers), 1);
  if (! isempty (left_out))
    scene_error ("%s: argument %d is missing, where argument %d is stated", which, left_out, numel (numbers));
  endif
endfunction

function scene = evaluate (file, numbers)
  before = path ();
  aside = tempname ();
  [folder, name] = fileparts (file);
  warning ("off", "Octave:function-name-clash", "local");
  warning ("off", "Octave:shadowed-function", "local");
  unwind_protect
    if (! any (folder == pathsep ()))
      addpath (folder);
    endif
    if (! is_called_by (name, file))
      name = copy_aside (file, aside);
    endif
    scene = called_scene (name, numbers, file);
  unwind_protect_cleanup
    path (before);
    if (isfolder (aside))
      confirm_recursive_rmdir (false, "local");
      rmdir (aside, "s");
    endif
  end_unwind_protect
endfunction

## Not every name can be called, and a name may mean a file of the working directory.
function yes = is_called_by (name, file)
  yes = isvarname (name);
  if (yes)
    forget_other (name, file);
    yes = strcmp (which (name), file);
  endif
endfunction

## A file that is what it was stays: without it, loads of a scene before, that call functions in it, could not.
function forget_other (name, file)
  persistent known = struct ();
  now = {file, fileread(file)};
  if (! isequal (field_or (known, name, {}), now))
    clear (name);
    known.(name) = now;
  endif
endfunction

function name = copy_aside (file, aside)
  name = "scene_by_its_path";
  mkdir (aside);
  write_text (fullfile (aside, [name ".m"]), fileread (file));
  addpath (aside);
  clear (name);
endfunction

%!assert (load_scene ("paper").duration, 1.8)
%!assert (numel (load_scene ("chain(3)").bodies), 3)
%!assert (numel (load_scene ("chain ( )").bodies), 5)
%!assert (numel (load_scene ("chain", {4}).bodies), 4)
%!assert (numel (load_scene ("chain(3)", {[]}).bodies), 3)
%!assert (numel (load_scene ("chain(3)", {4}).bodies), 4)
%!error <chain: argument 1 is missing, where argument 2 is stated> load_scene ("chain", {[], 4})
%!test # loaded again, it leaves the loads of the first time as they are, and what these call
%! first = load_scene ("two_link_arm");
%! load_scene ("two_link_arm");
%! assert (numel (first.joints{2}.value (0.1)), 3);
%!function check_path (folder, name, typed, calls = "")
%!  ## the scene in the file FOLDER/NAME.m, read by what a user types in the folder's parent
%!  before = pwd (); [root, gone] = scratch_folder ();
%!  unwind_protect
%!    cd (root); mkdir (fullfile (root, folder));
%!    write_text (fullfile (root, folder, [name ".m"]), ...
%!                ["function s = rod (k = 4)\n s.duration = helper (k); s.moment = @(t) helper (t);\nend\n" ...
%!                 "function k = helper (k)\nend\n"]);
%!    write_text (fullfile (root, "rod.m"), "function s = rod ()\n s.duration = -1;\nend\n");
%!    [scene, got] = load_scene ([typed calls]);
%!    assert (scene.duration, 4 + 3 * ! isempty (calls)); assert (got, name);
%!    assert (scene.moment (3), 3);
%!    [file, ~, again] = find_scene ([typed calls]);
%!    assert (fileread (file), fileread (fullfile (root, folder, [name ".m"])));
%!    cd (tempdir ()); assert (load_scene (again).duration, scene.duration);
%!  unwind_protect_cleanup
%!    cd (before);
%!  end_unwind_protect
%!endfunction
%!test # a folder of any name
%! for folder = {"own scenes", "copy (2)", "chain(2)", "it's", "a\"b", "$HOME", "#1", "naïve →", "-eval", "~", ...
%!               "a:b", "[x]*", "%d\\n", "{a,b}", "`x` & y; z", "trailing ", "dots.and..more"}
%!   check_path (folder{1}, "rod", ["./" folder{1} "/rod.m"]);
%!   check_path (folder{1}, "rod", ["./" folder{1} "/rod"], " (7)");
%! endfor
%!test check_path ("-eval", "rod", "-eval/rod.m", "(7)");
%!test # a file of any name
%! for name = {"rod (2)", "my-rod", "2nd", "it's $HOME", "-rod", "naïve", "a.b"}
%!   check_path ("of mine", name{1}, ["of mine/" name{1} ".m"]);
%! endfor
%!test # ~ is home
%! home = getenv ("HOME");
%! unwind_protect
%!   setenv ("HOME", "/nowhere/rods");
%!   fail ("load_scene ('~/rod.m')", 'no scene "~/rod.m"');
%!   setenv ("HOME", fileparts (which ("paper")));
%! unwind_protect_cleanup
%!   setenv ("HOME", home);
%! end_unwind_protect
%!function check_edited (folder, scratch)
%!  before = pwd ();
%!  unwind_protect
%!    cd (folder);
%!    for duration = [1 2]
%!      write_text ("edited.m", sprintf ("function s = edited ()\n s.duration = %d;\nend\n", duration));
%!      assert (load_scene ("./edited.m").duration, duration);
%!    endfor
%!  unwind_protect_cleanup
%!    cd (before);
%!  end_unwind_protect
%!endfunction
%!test # a file that was edited is read again, even within the second that file times tell
%! in_scratch (@check_edited);
