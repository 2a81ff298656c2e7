## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} called_scene (@var{name}, @var{numbers}, @var{file})
## The scene that the function @var{name} returns for the @var{numbers} (cell array).  What fails in it is an error
## with the line of the scene's @var{file}, whose name may be another (see @code{load_scene}), or of what it calls.
## @end deftypefn

function scene = called_scene (name, numbers, file)
  try
    scene = feval (name, numbers{:});
  catch err
    if (! isempty (err.identifier) || is_raised (err.stack(1)))
      rethrow_others (err, "Octave:");
    endif
    err = struct ("message", err.message, "identifier", "Octave:", "stack", err.stack);
    [~, own, extension] = fileparts (file);
    scene_error ("%s", strrep (placed_message (err), [name ".m"], [own extension]));
  end_try_catch
endfunction

## by a call of error in a line of a file: some errors of the interpreter have no identifier either
function yes = is_raised (place)
  lines = {};
  if (exist (place.file, "file"))
    lines = strsplit (fileread (place.file), "\n");
  endif
  yes = place.line < 1 || place.line > numel (lines) || ! isempty (regexp (lines{place.line}, '\<error\>'));
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
%!    write_text (file, "function s = odd_rod ()\n  s.title = 'x';\n  s.zoom = [1 2; 3];\nend\n");
%!    fail ("load_scene (file)", ["^" regexptranslate("escape", name{1}) "\\.m, line 3: vertical dimensions mismatch"]);
%!  endfor
%!endfunction
%!test in_scratch (@(folder, scratch) check (folder));
%!error <^swing: function called with too many inputs> load_scene ("swing(3)")
