## -*- texinfo -*-
## @deftypefn {} {@var{factor} =} mode_growth (@var{solver}, @var{h_omega})
## By what a step multiplies the amplitude of the highest mode of the paper's rod with 7 + 7 modes, on the
## nonlinear equations, in equal steps h of @var{solver} (see @code{integrate}), h*omega = @var{h_omega}: the
## mean of 200 steps after the first 100.  The mode begins at 1 micrometre.  0 where nothing is left of it, NaN
## where the integration fails.
## @end deftypefn

function factor = mode_growth (solver, h_omega)
  system = free_rod ([7 7], struct ());
  n = rows (system.mass);
  [X, squares] = free_modes (system.stiffness, system.mass);
  [square, highest] = max (squares);
  [x, omega] = deal (X(:,highest), sqrt (square));
  system.initial_state(1:n) += 1e-6*x/norm (x);
  solver.step = h_omega/omega;
  times = solver.step*[0 100 300];
  system.duration = times(end);
  try
    states = integrate (system, times, solver);
    amplitudes = hypot (x.'*system.mass*states(1:n,:), ...
                        x.'*system.mass*(system.velocity_matrix \ states(n+1:2*n,:))/omega);
    factor = 0;
    if (amplitudes(3) > 0)
      factor = (amplitudes(3)/amplitudes(2))^(1/200);
    endif
  catch err
    rethrow_others (err, "toolchain:integration");
    factor = NaN;
  end_try_catch
endfunction

%!test # below its limit of 2.83 the classical method damps, beyond it grows, as its stability function has it
%! solver = struct ("name", "rk4", "tolerance", 1, "rho_infinity", 1);
%! for h_omega = [2 2.9]
%!   assert (mode_growth (solver, h_omega), abs (polyval (stability_function ("rk4"), 1i*h_omega)), 1e-3);
%! endfor
%!test # backward differences of order 1 damp by 1/sqrt (1 + (h omega)^2), to nothing far beyond the step
%! solver = struct ("name", "lsode_bdf", "tolerance", 1, "order", 1);
%! assert (mode_growth (solver, 1), 1/sqrt (2), 1e-6);
%! assert (mode_growth (solver, 1e4), 0);
%!assert (mode_growth (struct ("name", "rk4", "tolerance", 1, "rho_infinity", 1), 20), NaN)  # it fails
