## -*- texinfo -*-
## @deftypefn {} {@var{taken} =} take_fields (@var{given}, @var{fields}, @var{what})
## The struct @var{given} with all @var{fields}, a row each: name, default, kind (see @code{value_error}), a
## default of NaN where the field must be given.  Errors name @var{what} it is ("a scene"), the field, what it got
## and what it takes.
## @end deftypefn

function taken = take_fields (given, fields, what)
  refuse_unknown (given, "", fields(:,1), what);
  taken = struct ();
  for field = fields.'
    [name, value, kind] = field{:};
    path = strsplit (name, ".");
    if (has_field (given, path) && ! (isequal (value, []) && isequal (getfield (given, path{:}), [])))
      value = getfield (given, path{:});
      got = value_error (kind, value);
      if (! isempty (got))
        scene_error ("%s%s is %s: it takes %s", field_prefix (what), name, got, kind);
      endif
    elseif (isnumeric (value) && isscalar (value) && isnan (value))
      scene_error ("%s%s is missing: it takes %s", field_prefix (what), name, kind);
    endif
    taken = setfield (taken, path{:}, value);
  endfor
endfunction

function refuse_unknown (given, prefix, names, what)
  for [value, key] = given
    name = [prefix key];
    if (any (strncmp ([name "."], names, numel (name) + 1)))
      if (! (isstruct (value) && isscalar (value)))
        scene_error ("%s%s is a %s%s: it takes a struct", field_prefix (what), name, class (value), ...
                     repmat (" array", 1, isstruct (value)));
      endif
      refuse_unknown (value, [name "."], names, what);
    elseif (! any (strcmp (name, names)))
      scene_error ("%s%s is not a field of %s: those are %s", field_prefix (what), name, what, strjoin (names.', ", "));
    endif
  endfor
endfunction

%!assert (take_fields (struct ("a", 2), {"a", 1, "number"; "b.c", 3, "number"}, "a thing"), ...
%!        struct ("a", 2, "b", struct ("c", 3)))
%!error <bodies\(2\).a is missing: it takes number> take_fields (struct (), {"a", NaN, "number"}, "bodies(2)")
%!error <bodies\(2\).c is not a field of bodies\(2\): those are a>
%! take_fields (struct ("c", 3), {"a", 1, "number"}, "bodies(2)");
%!assert (take_fields (struct ("b", struct ("c", 4)), {"b.c", 3, "number"}, "a scene").b.c, 4)
%!error <^a is -1: it takes positive number> take_fields (struct ("a", -1), {"a", 1, "positive number"}, "a scene")
%!error <^bodies\(2\).a is -1: it takes> take_fields (struct ("a", -1), {"a", 1, "positive number"}, "bodies(2)")
%!error <^b is a double: it takes a struct> take_fields (struct ("b", 3), {"b.c", 3, "number"}, "a scene")
%!error <^b is a struct array: it takes a struct>
%! take_fields (setfield (struct (), "b", struct ("c", {1 2})), {"b.c", 3, "number"}, "a scene")
%!error <^bc is not a field of a scene: those are b.c>
%! take_fields (struct ("bc", struct ("c", 3)), {"b.c", 3, "number"}, "a scene")
