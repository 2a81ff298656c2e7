## -*- texinfo -*-
## @deftypefn {} {@var{h} =} longest_step (@var{model})
## The longest step (s) of a method that takes the free oscillation of the modes exactly: one and a half radians of
## the first longitudinal mode, Inf where none vibrates.  The rate of rotation follows its stretch, which is not
## part of the free oscillation, and longer steps would see it at odd times only.
## @end deftypefn

function h = longest_step (model)
  n = model.rung.longitudinal*strcmp (model.rung.axial, "dynamic");
  K = diag (model.arrays.stiffness_matrix);
  M = diag (model.arrays.mass_matrix);
  h = 1.5/max ([sqrt(min (K(1:n)./M(1:n))), 0]);
endfunction

%!test
%! scene = check_scene (paper ());
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 2, "axial", "dynamic", "stiffening", "none");
%! omega = pi/2*sqrt (4*(1.2e11 + 8.1e10)/7800);
%! assert (longest_step (build_model (scene, rung)), 1.5/omega, 1e-3*1.5/omega);
%! rung.axial = "none";
%! assert (longest_step (build_model (scene, rung)), Inf);
