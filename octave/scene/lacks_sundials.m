## -*- texinfo -*-
## @deftypefn {} {@var{lacks} =} lacks_sundials (@var{method}, @var{built_with})
## Whether the @var{method} is one of the codes of SUNDIALS, ode15s or ode15i, and this Octave was built without it, as
## Debian 13's is; @var{built_with} says so in tests.
## @end deftypefn

function lacks = lacks_sundials (method, built_with = __have_feature__ ("SUNDIALS"))
  lacks = any (strcmp (method, {"ode15s", "ode15i"})) && ! built_with;
endfunction

%!assert (lacks_sundials ("ode15s", false) && lacks_sundials ("ode15i", false))
%!assert (! lacks_sundials ("ode15s", true) && ! lacks_sundials ("ode45", false))
%!test # what Octave says of itself is so
%! runs = true;
%! try
%!   [~, y] = ode15s (@(t, y) -y, [0 1], 1);
%! catch
%!   runs = false;
%! end_try_catch
%! assert (lacks_sundials ("ode15s"), ! runs);
