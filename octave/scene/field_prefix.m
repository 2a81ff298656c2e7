## -*- texinfo -*-
## @deftypefn {} {@var{prefix} =} field_prefix (@var{what})
## What stands before the names of the fields of a part of a scene in messages: "bodies(2)." of @var{what} = bodies(2),
## nothing of "a scene".
## @end deftypefn

function prefix = field_prefix (what)
  prefix = "";
  if (any (what == "("))
    prefix = [what "."];
  endif
endfunction

%!assert ({field_prefix("bodies(2)"), field_prefix("a scene")}, {"bodies(2).", ""})
