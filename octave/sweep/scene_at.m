## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{output}] =} scene_at (@var{which}, @var{options}, @var{columns}, @var{values})
## The scene of a point of a sweep: what @var{which} is (see @code{load_scene}), with the @var{options} of
## @code{driver}, and with the @var{values} (cell array) in the fields that the @var{columns} name; those of
## "argument.1" are the arguments.  @var{output} is that of @code{take_options}.
## @end deftypefn

function [scene, output] = scene_at (which, options, columns, values)
  places = str2double (regexp (columns, '(?<=^argument\.)\d+$', "match", "once"));
  arguments = cell (1, max ([0, places]));
  for k = find (isfinite (places))(:).'  # of 0-by-0 places Octave 11 would go round once
    if (! isnumeric (values{k}))
      scene_error ("%s is \"%s\": it takes a number", columns{k}, values{k});
    endif
    arguments{places(k)} = values{k};
  endfor
  [scene, name] = load_scene (which, arguments);
  [scene, output] = take_options (scene, "", options);
  for k = find (isnan (places))(:).'
    scene = with_field (scene, columns{k}, values{k});
  endfor
  if (isempty (field_or (scene, "title", "")))
    scene.title = name;
  endif
endfunction

%!test
%! scene = scene_at ("chain(2)", {"tolerance", 1e-3}, {"bodies(3).rod.length", "solver.name", "argument.1"}, ...
%!                   {0.3, "radau", 3});
%! assert (cellfun (@(body) body.rod.length, scene.bodies), [0.1 0.1 0.3]);
%! assert (scene.solver, struct ("tolerance", 1e-3, "name", "radau")); assert (scene.title, "A chain of 3 rods");
%! assert (scene_at (struct ("b", 1), {}, {"a"}, {2}), struct ("b", 1, "a", 2, "title", "scene"));
%! assert (scene_at ("swing", {}, {}, {}), swing ());
%! assert (scene_at ("swing", {"tolerance", 1}, {"solver.tolerance"}, {2}).solver.tolerance, 2);  # the point's own
%!error <argument.1 is "x": it takes a number> scene_at ("chain", {}, {"argument.1"}, {"x"})
