## Three independent methods agree on the paper's scene with 0 + 7 modes.

%!test # to 1e-8 in tip and hinge angle over all frames
%! scene = check_scene (setfield (paper (), "model", "modes", [0 7]));
%! model = build_model (scene, rung_of_scene (scene));
%! system = hinged_rod (scene, model);
%! times = frame_times (scene);
%! reference = measure (system, model, times, integrate (system, times, struct ("name", "waveform", "tolerance", 1e-10)));
%! ## 4e-8 m of the centreline are 1e-10 as these methods take it
%! for name = {"ode45", "lsode_adams"}
%!   [states, count] = integrate (system, times, struct ("name", name{1}, "tolerance", 4e-8));
%!   history = measure (system, model, times, states);
%!   printf ("%s: tip %.2g m, phi %.2g rad, %.0f s\n", name{1}, max (hypot (history.tip_x - reference.tip_x, ...
%!           history.tip_y - reference.tip_y)), max (abs (history.phi - reference.phi)), count.seconds);
%!   assert (history.phi, reference.phi, 1e-8);
%!   assert (hypot (history.tip_x - reference.tip_x, history.tip_y - reference.tip_y), zeros (1, 91), 1e-8);
%! endfor
