## -*- texinfo -*-
## @deftypefn {} {@var{list} =} take_list (@var{given}, @var{fields}, @var{name}, @var{one}, @var{check})
## The parts of a scene that are alike, @var{given} as a cell array of structs or a struct array, as a struct array:
## each with all @var{fields} (see @code{take_fields}) and a name of its own, what @var{check} (part, what) returns.
## Errors call the second of "bodies", the list's @var{name}, bodies(2), where @var{name} is no cell array of what each
## is called; without a name it is "body 2", where @var{one} is "body".
## @end deftypefn

function list = take_list (given, fields, name, one, check)
  if (isstruct (given))
    given = num2cell (given);
  endif
  list = struct ([]);
  for k = 1:numel (given)
    what = name_of (name, k);
    if (! (isstruct (given{k}) && isscalar (given{k})))
      scene_error ("%s is a %s: it takes a struct", what, class (given{k}));
    endif
    part = check (take_fields (given{k}, fields, what), what);
    if (isempty (part.name))
      part.name = sprintf ("%s %d", one, k);
    endif
    list = [list, part];
  endfor
  if (isempty (list))
    names = unique (strtok (fields(:,1), "."));
    list = cell2struct (cell (0, numel (names)), names, 2).';
  endif
endfunction

function what = name_of (name, k)
  if (iscell (name))
    what = name{k};
  else
    what = sprintf ("%s(%d)", name, k);
  endif
endfunction

%!function list = taken (given, name = "bodies")
%!  fields = {"name", "", "text"; "mass", 1, "positive number in kg"};
%!  list = take_list (given, fields, name, "body", @(part, what) part);
%!endfunction
%!assert (taken ({struct("mass", 2), struct("name", "stone")}), struct ("name", {"body 1", "stone"}, "mass", {2, 1}))
%!assert (taken (struct ("mass", {2, 3}))(2).mass, 3)
%!assert (size (taken ({})), [1 0])
%!error <bodies\(2\).mass is -1: it takes positive number in kg> taken ({struct(), struct("mass", -1)})
%!error <^mass is -1: it takes positive number in kg> taken ({struct(), struct("mass", -1)}, {"bodies(1)", "a rod"})
%!error <bodies\(1\) is a double: it takes a struct> taken ({3})
