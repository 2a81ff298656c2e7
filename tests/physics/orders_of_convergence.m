## The fixed-step methods converge with their orders on the paper's rod, across the break of a moment that grows to
## 90 N m ten times as fast as the paper's.

%!function off = error_at (system, method, h, reference)
%!  states = integrate (system, [0 0.02 0.035], struct ("name", method, "tolerance", 1, "step", h, "rho_infinity", 0.8));
%!  off = norm ((states - reference)(1:2,3));
%!endfunction

%!test # order within 0.05 of the theory, as the step is halved
%! [scene, model] = sample_rod ([0 1], "duration", 0.035, "moment", @(t) 3000*t.*(t < 0.03), "moment_breaks", 0.03);
%! system = hinged_rod (scene, model);
%! reference = integrate (system, [0 0.02 0.035], struct ("name", "waveform", "tolerance", 1e-13));
%! for method = integrator_table (system.forms)
%!   if (! method.adaptive)
%!     error_with = @(step) error_at (system, method.name, step, reference);
%!     order = log2 (error_with (1e-4)/error_with (5e-5));
%!     printf ("%s: order %.3f\n", method.name, order);
%!     assert (order, method.order, 0.05);
%!   endif
%! endfor
