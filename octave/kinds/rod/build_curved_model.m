## -*- texinfo -*-
## @deftypefn {} {@var{model} =} build_curved_model (@var{scene}, @var{rung})
## The model of a checked scene's curved rod with rung.sines = [N1 N2] base functions (see @code{curved_functions}):
## the fields of @code{build_model}, with the same arrays from quadrature (see @code{curved_base}).
## @end deftypefn

function model = build_curved_model (scene, rung)
  at_O = zeros (1, rung.sines(2) > 0 && any (scene.moment (load_times (scene))));
  across = [1:rung.sines(2), moment_corrections(at_O, scene.rod.length)];
  model = rod_model (scene, rung, base_functions (1:rung.sines(1), across, scene.rod.length));
  model.equations = matrix_equations ();
  arrays = model.arrays;
  [model.whole_mass_matrix, model.whole_coupling_vector] = deal (arrays.mass_matrix, arrays.coupling_vector);
  [model.arrays.follower_dd, model.arrays.follower_ds, model.arrays.follower_ss] = deal (0);
  [model.arrays.follower_fd, model.arrays.follower_fs, model.arrays.follower_ff] = deal (0);
  tip = curved_functions (model.base, model.base.axis, model.length);
  model.force = struct ("shape_1", tip.u_1.', "shape_2", tip.u_2.', ...
                        "shortening_matrix", zeros (size (arrays.mass_matrix)));
endfunction

%!function model = semicircle (N, degrees)
%!  angle = deg2rad (degrees);
%!  scene.rod = struct ("length", 1, "curvature", angle, "EA", 1e6, "EI", 10, "rhoA", 1); scene.duration = 1;
%!  scene = check_scene (scene);
%!  model = build_curved_model (scene, curved_rung ([N N]));
%!endfunction
%!test # the mass matrix's condition, rotation included, does not grow with N beyond that of the base functions
%! for degrees = [1 180 300]
%!   for N = [4 16]
%!     a = semicircle (N, degrees).arrays;
%!     scale = diag (1./sqrt (diag (a.mass_matrix)));
%!     whole = [scale*a.mass_matrix*scale, scale*a.coupling_vector; a.coupling_vector.'*scale, a.moment_of_inertia];
%!     condition(1 + (N > 4)) = cond (whole);
%!   endfor
%!   assert (condition(2) < 400);
%! endfor
%!test # without weight and load a turn of the frame alone keeps the energy: the base has no angular momentum
%! a = semicircle (3, 90).arrays;
%! assert (a.coupling_vector, zeros (6, 1), 1e-10);
