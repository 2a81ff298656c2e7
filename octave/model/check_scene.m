## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} check_scene (@var{given})
## The scene with all its fields: those @var{given}, checked, and the defaults of @code{scene_fields} for the others.
##
## An unknown field, or a value of a wrong type, size or sign, or one that is not finite, is an error that names the
## field, what it got and what it takes.
## @end deftypefn

function scene = check_scene (given)
  if (! (isstruct (given) && isscalar (given)))
    scene_error ("a scene is a function that returns a struct, not a %s", class (given));
  endif
  fields = scene_fields ();
  refuse_unknown (given, "", fields(:,1));
  scene = struct ();
  for field = fields.'
    [name, value, kind] = field{:};
    path = strsplit (name, ".");
    if (has_field (given, path))
      value = getfield (given, path{:});
      got = value_error (kind, value);
      if (! isempty (got))
        scene_error ("%s is %s: it takes %s", name, got, kind);
      endif
    elseif (isnumeric (value) && isscalar (value) && isnan (value))
      scene_error ("%s is missing: it takes %s", name, kind);
    endif
    scene = setfield (scene, path{:}, value);
  endfor
  check_section (scene.rod);
  scene.moment_breaks = unique (scene.moment_breaks(:).');
  scene.moment = moment_function (scene.moment, scene.duration);
endfunction

function refuse_unknown (given, prefix, names)
  for [value, key] = given
    name = [prefix key];
    if (any (strncmp ([name "."], names, numel (name) + 1)))
      if (! (isstruct (value) && isscalar (value)))
        scene_error ("%s is a %s: it takes a struct", name, class (value));
      endif
      refuse_unknown (value, [name "."], names);
    elseif (! any (strcmp (name, names)))
      scene_error ("%s is not a field of a scene: those are %s", name, strjoin (names.', ", "));
    endif
  endfor
endfunction

function found = has_field (given, path)
  found = isfield (given, path{1}) && (numel (path) == 1 || isfield (given.(path{1}), path{2}));
endfunction

function check_section (rod)
  own = ! cellfun (@isempty, {rod.EA, rod.EI, rod.rhoA});
  if (any (own) && ! all (own))
    scene_error ("rod.EA, rod.EI and rod.rhoA are given together or not at all");
  elseif (! any (own) && (isempty (rod.width) || isempty (rod.half_height)))
    scene_error ("rod.width and rod.half_height are missing: they take positive numbers in m");
  endif
endfunction

function moment = moment_function (moment, duration)
  if (isnumeric (moment))
    moment = @(t) moment + zeros (size (t));
  endif
  times = [0, duration/2, duration];
  try
    values = moment (times);
  catch err
    scene_error ("moment fails at t = [%s]: %s", num2str (times), err.message);
  end_try_catch
  if (! (isnumeric (values) && isreal (values) && isequal (size (values), size (times)) && all (isfinite (values))))
    scene_error ("moment gives %s at t = [%s]: it takes a vectorised function of t in N m", mat2str (values), num2str (times));
  endif
endfunction

%!function scene = smallest ()
%!  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.015), "duration", 1);
%!endfunction

%!test # defaults are filled in
%! scene = check_scene (smallest ());
%! assert (scene.gravity, 9.81);
%! assert (scene.rod.density, 7800);
%! assert (scene.moment (3), 0);
%!error <rod.length is missing: it takes positive number in m> check_scene (struct ("rod", struct ()))
%!error <rod.length is NaN: it takes positive number in m> check_scene (setfield (smallest (), "rod", "length", NaN))
%!error <colour is not a field of a scene: those are title, rod.length,> check_scene (setfield (smallest (), "colour", 1))
%!error <rod.colour is not a field of a scene> check_scene (setfield (smallest (), "rod", "colour", 1))
%!error <rod is a double: it takes a struct> check_scene (setfield (smallest (), "rod", 3))
%!error <rod.width and rod.half_height are missing>
%! check_scene (struct ("rod", struct ("length", 1), "duration", 1))
%!error <rod.EA, rod.EI and rod.rhoA are given together> check_scene (setfield (smallest (), "rod", "EA", 1))
%!error <moment gives 300 at t = \[0.*1\]: it takes a vectorised function>
%! check_scene (setfield (smallest (), "moment", @(t) 300))
%!error <moment fails at t = .*nonconformant> check_scene (setfield (smallest (), "moment", @(t) t*t))
%!error <a scene is a function that returns a struct, not a double> check_scene (3)
%!error <initial.V1 is "a": it takes vector of amplitudes in m> check_scene (setfield (smallest (), "initial", "V1", "a"))
