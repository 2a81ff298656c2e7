## -*- texinfo -*-
## @deftypefn {} {@var{table} =} usable_methods (@var{table}, @var{built_with})
## The methods of a @var{table} (see @code{integrator_table}) that this Octave has (see
## @code{lacks_sundials}); which are left out is printed.
## @end deftypefn

function table = usable_methods (table, varargin)
  missing = cellfun (@(name) lacks_sundials (name, varargin{:}), {table.name});
  if (any (missing))
    printf ("  %s left out: this Octave was built without SUNDIALS\n", strjoin ({table(missing).name}, ", "));
  endif
  table = table(! missing);
endfunction

%!test
%! table = integrator_table ({"constrained"});
%! text = evalc ("left = usable_methods (table, false);");
%! assert (text, "  ode15i left out: this Octave was built without SUNDIALS\n");
%! assert (setdiff ({table.name}, {left.name}), {"ode15i"});
%!test
%! assert ({usable_methods(integrator_table (), true).name}, {integrator_table().name});
