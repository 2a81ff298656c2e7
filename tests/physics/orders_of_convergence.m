## The fixed-step methods converge with their orders on the paper's scene, across the break of the moment at 0.3 s.

%!function off = error_at (system, method, h, reference)
%!  states = integrate (system, [0 0.2 0.35], struct ("name", method, "tolerance", 1, "step", h, "rho_infinity", 0.8));
%!  off = norm ((states - reference)(1:2,3));
%!endfunction

%!test # order within 0.1 of the theory, as the step is halved
%! [scene, model] = sample_rod ([0 1], "duration", 0.35);
%! system = hinged_rod (scene, model);
%! reference = integrate (system, [0 0.2 0.35], struct ("name", "waveform", "tolerance", 1e-13));
%! for method = integrator_table (rod_forms ())
%!   if (! method.adaptive)
%!     error_with = @(step) error_at (system, method.name, step, reference);
%!     order = log2 (error_with (5e-5)/error_with (2.5e-5));
%!     printf ("%s: order %.3f\n", method.name, order);
%!     assert (order, method.order, 0.1);
%!   endif
%! endfor
