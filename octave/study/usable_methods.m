## -*- texinfo -*-
## @deftypefn {} {@var{table} =} usable_methods (@var{table})
## The methods of a @var{table} (see @code{integrator_table}) that this Octave has (see @code{lacks_sundials}); which
## are left out is printed.
## @end deftypefn

function table = usable_methods (table)
  missing = cellfun (@lacks_sundials, {table.name});
  if (any (missing))
    say ("  %s left out: this Octave was built without SUNDIALS", strjoin ({table(missing).name}, ", "));
  endif
  table = table(! missing);
endfunction

%!test
%! table = integrator_table ({"constrained"});
%! built = {"yes = __have_feature__", "name", "yes = false;"};
%! call = "with_stand_ins (built, @() printf (\"%s \", usable_methods (table).name));";
%! left = setdiff ({table.name}, {"ode15i"}, "stable");
%! assert (evalc (call), ["  ode15i left out: this Octave was built without SUNDIALS\n" sprintf("%s ", left{:})]);
%! built{3} = "yes = true;";
%! assert (evalc (call), sprintf ("%s ", table.name));
