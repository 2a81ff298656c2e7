## -*- texinfo -*-
## @deftypefn {} {} reach_beside (@var{which})
## What stands in the folder of a scene's own file (see @code{find_scene}) can be called from now on, by the functions
## in the scene: the folder is the last on the load path.  Shipped scenes stay off it, and so does a folder whose name
## has what separates folders there.
## @end deftypefn

function reach_beside (which)
  folder = fileparts (find_scene (which));
  shipped = fileparts (find_scene ("paper"));
  if (! strcmp (folder, shipped) && ! any (folder == pathsep ()))
    addpath (folder, "-end");
  endif
endfunction

%!function check (folder, scratch)
%!  write_text (fullfile (folder, "scene_beside.m"), "function s = scene_beside ()\n s = @() beside ();\nend\n");
%!  write_text (fullfile (folder, "beside.m"), "function y = beside ()\n y = 3;\nend\n");
%!  file = fullfile (folder, "scene_beside.m");
%!  of_scene = load_scene (file);
%!  fail ("of_scene ()", "'beside' undefined");
%!  before = path ();
%!  unwind_protect
%!    reach_beside ("paper");
%!    assert (path (), before);
%!    reach_beside (file);
%!    assert (of_scene (), 3);
%!  unwind_protect_cleanup
%!    path (before);
%!  end_unwind_protect
%!endfunction
%!test in_scratch (@check);
