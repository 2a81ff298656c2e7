## -*- texinfo -*-
## @deftypefn {} {@var{kappa} =} curvature_at (@var{rod}, @var{xi})
## The curvature (1/m) of the undeformed centreline of a @var{rod} (a checked scene's field) at the stations @var{xi}
## (m, any size): a number, coefficients of the powers of xi/length from the constant on, or a function of xi that
## returns a number for each.
## @end deftypefn

function kappa = curvature_at (rod, xi)
  if (! is_function_handle (rod.curvature))
    kappa = zeros (size (xi));
    if (any (rod.curvature))
      kappa = polyval (flipud (rod.curvature(:)), xi/rod.length) + kappa;
    endif
    return;
  endif
  try
    kappa = rod.curvature (xi);
  catch err
    scene_error ("rod.curvature fails: %s", placed_message (err));
  end_try_catch
  if (! (isnumeric (kappa) && isreal (kappa) && isequal (size (kappa), size (xi)) && all (isfinite (kappa(:)))))
    scene_error (["rod.curvature gives %d values for %d stations or no numbers: it takes a vectorised function" ...
                  " of xi in 1/m"], numel (kappa), numel (xi));
  endif
endfunction

%!test # by coefficients, and by a function
%! rod = struct ("length", 2, "curvature", [1 2 3]);
%! assert (curvature_at (rod, [0; 1; 2]), [1; 2.75; 6], 1e-15);
%! assert (curvature_at (setfield (rod, "curvature", @(xi) xi.^2), [0; 1; 2]), [0; 1; 4]);
%! assert (curvature_at (setfield (rod, "curvature", []), [0 1]), [0 0]);
%!error <rod.curvature gives 1 values for 2 stations> curvature_at (struct ("curvature", @(xi) 1), [0 1])
%!error <rod.curvature fails: no> curvature_at (struct ("length", 1, "curvature", @(xi) error ("no")), 0.5)
%!error <rod.curvature gives 1 values for 1 stations or no numbers>
%! curvature_at (struct ("length", 1, "curvature", @(xi) 1i*xi), 0.5)
