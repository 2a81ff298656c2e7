## -*- texinfo -*-
## @deftypefn {} {} refuse_negative_mass (@var{linear}, @var{where})
## An error that says @var{where} (a text, "at t = 1 s" say) the mass matrix of @var{linear} (see @code{linearised}) is
## not positive, by more than rounding: foreshortening of the second order takes from it what bends much, and of many
## modes more than there is.
## @end deftypefn

function refuse_negative_mass (linear, where)
  scale = 1./sqrt (abs (diag (linear.M)(:)));
  if (any (eig (scale.*(linear.M + linear.M.')/2.*scale.') < -1e-12))
    error ("toolchain:scene:mass", ...
           ["%s the mass matrix is not positive: foreshortening of the second order does not hold for what so" ...
            " many modes bend; EXACT=yes has rods that bend so far, or state fewer modes, MODES=\"0 3\" say\n"], where);
  endif
endfunction

%!error <at t = 1 s the mass matrix is not positive.*state fewer modes, MODES="0 3" say>
%! refuse_negative_mass (struct ("M", [1 2; 2 1]), "at t = 1 s");
%!test # rounding is no negative mass
%! refuse_negative_mass (struct ("M", [2 1; 1 2]), ""); refuse_negative_mass (struct ("M", []), "");
%! refuse_negative_mass (struct ("M", [1, 1 + 1e-15; 1 + 1e-15, 1]), "");
