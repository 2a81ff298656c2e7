## -*- texinfo -*-
## @deftypefn {} {} refuse_negative_mass (@var{linear}, @var{where})
## An error that says @var{where} (a text, "at t = 1 s" say) the mass matrix of @var{linear} (see @code{linearised}) is
## not positive: foreshortening of the second order takes from it what bends much, and of many modes more than there
## is.
## @end deftypefn

function refuse_negative_mass (linear, where)
  if (! (min (eig ((linear.M + linear.M.')/2)) > 0))
    scene_error (["%s the mass matrix is not positive: foreshortening of the second order does not hold for what so" ...
                  " many modes bend; state fewer, MODES=\"0 3\" say"], where);
  endif
endfunction

%!error <at t = 1 s the mass matrix is not positive.*state fewer, MODES="0 3" say>
%! refuse_negative_mass (struct ("M", [1 2; 2 1]), "at t = 1 s");
%!test
%! refuse_negative_mass (struct ("M", [2 1; 1 2]), "");
