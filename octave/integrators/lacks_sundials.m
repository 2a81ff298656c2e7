## -*- texinfo -*-
## @deftypefn {} {@var{lacks} =} lacks_sundials (@var{method})
## Whether the @var{method} is one of the codes of SUNDIALS, ode15s or ode15i, and this Octave was built without it, as
## Debian 13's is.
## @end deftypefn

function lacks = lacks_sundials (method)
  lacks = any (strcmp (method, {"ode15s", "ode15i"})) && ! __have_feature__ ("SUNDIALS");
endfunction

%!test
%! lack = @() cellfun (@lacks_sundials, {"ode15s", "ode15i", "ode45"});
%! with_stand_ins ({"yes = __have_feature__", "name", "yes = false;"}, @() assert (lack (), [true true false]));
%!test # what Octave says of itself is so
%! runs = true;
%! try
%!   [~, y] = ode15s (@(t, y) -y, [0 1], 1);
%! catch
%!   runs = false;
%! end_try_catch
%! assert (lacks_sundials ("ode15s"), ! runs);
