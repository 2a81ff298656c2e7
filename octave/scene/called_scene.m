## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} called_scene (@var{name}, @var{numbers}, @var{file})
## The scene that the function @var{name} returns for the @var{numbers} (cell array).  What fails in it is an error
## with the line of the scene's @var{file}, whose name may be another (see @code{load_scene}), or of what it calls.
## @end deftypefn

function scene = called_scene (name, numbers, file)
  try
    scene = feval (name, numbers{:});
  catch err
    rethrow_others (err, "Octave:");
    [~, own, extension] = fileparts (file);
    scene_error ("%s", strrep (placed_message (err), [name ".m"], [own extension]));
  end_try_catch
endfunction

%!function check (folder)
%!  for name = {"odd_rod", "odd rod (2)"}
%!    file = fullfile (folder, [name{1} ".m"]);
%!    write_text (file, ["function s = odd_rod (k)\n  s.title = 'x';\n  s.duration = [1 2](k);\n" ...
%!                       "  s.zoom = beside (k);\nend\n"]);
%!    write_text (fullfile (folder, "beside.m"), ["function y = beside (k)\n  if (k == 2)\n    error ('no');\n" ...
%!                                                 "  end\n  y = nowhere (1);\nend\n"]);
%!    in_file = ["^" regexptranslate("escape", name{1}) "\\.m, line 3: .*index \\(7\\): out of bound"];
%!    fail ("load_scene (file, {7})", in_file);
%!    fail ("load_scene (file, {1})", "^beside.m, line 5: 'nowhere' undefined$");
%!    fail ("load_scene (file, {2})", "^no$");
%!  endfor
%!endfunction
%!test in_scratch (@(folder, scratch) check (folder));
%!error <^swing: function called with too many inputs> load_scene ("swing(3)")
