## -*- texinfo -*-
## @deftypefn {} {@var{method} =} method_of (@var{system}, @var{name})
## The row of @code{integrator_table} of that @var{name} for a @var{system} (see @code{integrate}); "auto" is
## system.auto.
## @end deftypefn

function method = method_of (system, name)
  table = integrator_table (system.forms);
  if (strcmp (name, "auto"))
    name = system.auto;
  endif
  method = table(strcmp (name, {table.name}));
endfunction

%!test
%! system = struct ("forms", {{"residual", "rate"}}, "auto", "radau");
%! assert (method_of (system, "auto").form, "residual"); assert (method_of (system, "rk4").form, "rate");
