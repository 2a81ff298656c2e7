## -*- texinfo -*-
## @deftypefn {} {} check_surface_value (@var{name}, @var{value}, @var{kind})
## An error, which says what it takes, where the field @var{name} of a scene of a rod on a surface does not take the
## @var{value}: one of its @var{kind} in @code{surface_scene_fields}, as @code{value_error} knows them, or, where that
## knows too little, what is said here.
## @end deftypefn

function check_surface_value (name, value, kind)
  switch (name)
    case "ends"
      good = iscellstr (value) && numel (value) == 2 && all (ismember (value, {"free", "hinge", "clamped"}));
    case "force"
      good = is_function_handle (value) || (isnumeric (value) && numel (value) == 3 && all (isfinite (value)));
    case "initial.point"
      good = isnumeric (value) && isreal (value) && numel (value) == 2 && all (isfinite (value));
    case "model.modes"
      good = strcmp (value, "auto") || (isempty (value_error ("[N1 N2]", value)) && all (value >= 3));
      kind = [kind ", at least 3 each"];
    otherwise
      good = isempty (value_error (kind, value)) || (isempty (value) && ! isempty (strfind (name, "initial")));
  endswitch
  if (! good)
    got = value_error ("nothing", value);
    scene_error ("%s is %s: it takes %s", name, got, kind);
  endif
endfunction

%!error <ends is a 1-by-1 cell: it takes two of "free", "hinge" and "clamped">
%! check_surface_scene (on_level_plane ("ends", {{"free"}}))
%!error <ends is a 1-by-2 cell: it takes> check_surface_scene (on_level_plane ("ends", {{"free", "loose"}}))
%!error <model.modes is 2   2: it takes "auto" or two numbers>
%! check_surface_scene (setfield (on_level_plane (), "model", "modes", [2 2]))
%!error <force is 1   2: it takes three numbers> check_surface_scene (on_level_plane ("force", [1 2]))
%!error <initial.point is 1   2   3: it takes>
%! check_surface_scene (setfield (on_level_plane (), "initial", "point", [1 2 3]))
%!function check (name, value)   # of the kind that the table has
%!  fields = surface_scene_fields ();
%!  check_surface_value (name, value, fields{strcmp (fields(:,1), name),3});
%!endfunction
%!test # what else each takes and does not
%! check ("ends", {"hinge", "clamped"}); check ("force", [1 2 3]); check ("force", @(t) [t 0 0]);
%! check ("initial.point", [0.1 0.2]); check ("model.modes", "auto"); check ("model.modes", [3 4]);
%! check ("initial.shape", []); check ("gravity", 0);
%! fail ('check ("force", [1 2 Inf])', "force is .*Inf: it takes three numbers or function of t in N");
%! fail ('check ("initial.point", [1 NaN])', "initial.point is .*NaN: it takes vector of two coordinates");
%! fail ('check ("model.modes", [3 3.5])', "at least 3 each");
%! fail ('check ("rod.EA", [])', "rod.EA is a 0-by-0 double: it takes positive number in N");
