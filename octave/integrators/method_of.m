## -*- texinfo -*-
## @deftypefn {} {@var{method} =} method_of (@var{system}, @var{name})
## The row of @code{integrator_table} of that @var{name} for a @var{system} (see @code{integrate}); "auto" is
## system.auto.  A method for which the system has no form is an error with what system.refusal says of it.
## @end deftypefn

function method = method_of (system, name)
  table = integrator_table (system.forms);
  if (strcmp (name, "auto"))
    name = system.auto;
  endif
  method = table(strcmp (name, {table.name}));
  if (isempty (method))
    scene_error ("solver.name is \"%s\": %s", name, system.refusal);
  endif
endfunction

%!test
%! system = struct ("forms", {{"residual", "rate"}}, "auto", "radau");
%! assert (method_of (system, "auto").form, "residual"); assert (method_of (system, "rk4").order, 4);
%!error <solver.name is "trigonometric": it takes no hubs>
%! method_of (struct ("forms", {{"rate"}}, "auto", "rk4", "refusal", "it takes no hubs"), "trigonometric");
