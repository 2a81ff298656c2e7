## -*- texinfo -*-
## @deftypefn {} {@var{Phi} =} surface_constraints (@var{ends}, @var{model}, @var{length}, @var{slope})
## The linear constraints Phi*q = constant (c-by-N) that the @var{ends} (see @code{surface_scene_fields}) put on the
## coefficients q of a rod's base functions (see @code{rod_functions}): its point stays at a hinge, and where it is
## clamped also the direction of the chart's @var{slope} (2-by-2, a column an end).
## @end deftypefn

function Phi = surface_constraints (ends, model, length, slope)
  Phi = zeros (0, sum (model.modes + model.sines));
  for k = 1:2
    xi = (k - 1)*length;
    [values_1, slopes_1] = rod_functions (model, 1, xi, length);
    [values_2, slopes_2] = rod_functions (model, 2, xi, length);
    if (! strcmp (ends{k}, "free"))
      Phi = [Phi; blkdiag(values_1, values_2)];
    endif
    if (strcmp (ends{k}, "clamped"))
      across = [-slope(2,k), slope(1,k)]/norm (slope(:,k));
      Phi = [Phi; across(1)*slopes_1, across(2)*slopes_2];
    endif
  endfor
endfunction

%!test
%! Phi = surface_constraints ({"clamped", "hinge"}, struct ("modes", [3 4], "sines", [0 2]), 1, eye (2));
%! assert (size (Phi), [5 9]);
%! Phi = surface_constraints ({"clamped", "free"}, struct ("modes", [3 3], "sines", [0 0]), 2, eye (2));
%! assert (Phi, [1 -1 1 0 0 0; 0 0 0 1 -1 1; 0 0 0 0 1 -3], 1e-14);
