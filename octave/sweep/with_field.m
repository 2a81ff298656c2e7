## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} with_field (@var{scene}, @var{name}, @var{value})
## The @var{scene} with a @var{value} for the field of a dotted @var{name}, as "rod.length" or "bodies(2).rod.length".
## What is in parentheses must be there already; whether a scene has such a field, its check says.
## @end deftypefn

function scene = with_field (scene, name, value)
  scene = changed (scene, strsplit (name, "."), value, name);
endfunction

function given = changed (given, path, value, name)
  part = regexp (path{1}, '\w+', "match");
  field = part{1};
  if (numel (part) == 1)
    given.(field) = within (field_or (given, field, []), path, value, name);
    return;
  endif
  k = str2double (part{2});
  list = field_or (given, field, []);
  if (k > numel (list))
    scene_error ("%s: the scene has %d %s", name, numel (list), field);
  elseif (iscell (list))
    given.(field){k} = within (list{k}, path, value, name);
  else
    given.(field)(k) = within (list(k), path, value, name);
  endif
endfunction

function new = within (old, path, value, name)
  new = value;
  if (numel (path) > 1)
    if (isempty (old))
      old = struct ();
    elseif (! (isstruct (old) && isscalar (old)))
      scene_error ("%s: what is before .%s is a %s, not a struct", name, path{2}, class (old));
    endif
    new = changed (old, path(2:end), value, name);
  endif
endfunction

%!test
%! scene = struct ("rod", struct ("length", 1), "bodies", {{struct("x", 1), struct("x", 2)}}, "list", [1 2 3]);
%! assert (with_field (scene, "rod.length", 2).rod.length, 2);
%! assert (with_field (scene, "solver.name", "rk4").solver, struct ("name", "rk4"));
%! assert (with_field (scene, "bodies(2).x", 5).bodies, {struct("x", 1), struct("x", 5)});
%! assert (with_field (scene, "bodies(1).rod.length", 5).bodies{1}, struct ("x", 1, "rod", struct ("length", 5)));
%! assert (with_field (scene, "list(3)", 7).list, [1 2 7]);
%! scene.bodies = [scene.bodies{:}];
%! assert ([with_field(scene, "bodies(2).x", 5).bodies.x], [1 5]);
%!error <bodies\(3\).x: the scene has 2 bodies> with_field (struct ("bodies", {{1, 2}}), "bodies(3).x", 1)
%!error <bodies\(1\).x: the scene has 0 bodies> with_field (struct (), "bodies(1).x", 1)
%!error <rod.length.x: what is before .x is a double, not a struct>
%! with_field (struct ("rod", struct ("length", 1)), "rod.length.x", 1);
