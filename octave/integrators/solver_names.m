## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} solver_names (@var{forms})
## What the field solver.name of a scene takes (see @code{value_error}) whose systems have the @var{forms} (see
## @code{integrator_table}): "auto" and the names of methods, in quotes.
## @end deftypefn

function kind = solver_names (forms)
  names = strcat ({"\""}, {"auto", integrator_table(forms).name}, {"\""});
  kind = [strjoin(names(1:end-1), ", "), " or ", names{end}];
endfunction

%!assert (solver_names ({"residual"}), "\"auto\", \"generalized_alpha\", \"gauss\" or \"radau\"")
