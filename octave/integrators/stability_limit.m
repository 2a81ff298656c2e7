## -*- texinfo -*-
## @deftypefn {} {@var{limit} =} stability_limit (@var{method})
## The largest h*omega at which an undamped oscillation of frequency omega does not grow in steps of h: from the
## stability function of an explicit Runge-Kutta @var{method}, 2 for Stoermer and Verlet's; Inf for methods without a
## limit, or without a stability function.
## @end deftypefn

function limit = stability_limit (method)
  R = stability_function (method);
  if (strcmp (method, "stormer_verlet"))
    limit = 2;
  elseif (isempty (R))
    limit = Inf;
  else
    ## |R (i y)|^2 - 1 as a polynomial in y
    k = numel (R)-1:-1:0;
    on_axis = R.*(1i.^k);
    growth = real (conv (on_axis, conj (on_axis)));
    growth(end) = 0;
    growth(abs (growth) < 1e-14) = 0;
    y = roots (growth);
    y = sort (real (y(abs (imag (y)) < 1e-9 & real (y) > 1e-3)));
    limit = min ([y; Inf]);
    if (abs (polyval (R, 0.5i*limit)) > 1 + 1e-12)
      limit = 0;
    endif
  endif
endfunction

%!assert (stability_limit ("rk4"), 2*sqrt (2), 1e-12)
%!assert (stability_limit ("waveform"), Inf)
%!test # at the limit an oscillation neither grows nor decays, beyond it grows
%! for method = {"rk4", "ode45", "ode23"}
%!   limit = stability_limit (method{1});
%!   R = stability_function (method{1});
%!   assert (abs (polyval (R, 1i*limit)), 1, 1e-10);
%!   assert (abs (polyval (R, 1.01i*limit)) > 1);
%! endfor
