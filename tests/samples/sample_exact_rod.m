## -*- texinfo -*-
## @deftypefn {} {[@var{model}, @var{motion}, @var{gravity}] =} sample_exact_rod (@var{curvature})
## A geometrically exact rod with everything that one has, straight ([]) or of a @var{curvature} (see
## @code{free_rod_model}), bent and moving, in two states (see @code{motion_of_rods}), for tests.
## @end deftypefn

function [model, motion, gravity] = sample_exact_rod (curvature)
  body.rod = struct ("length", 1.5, "EA", 300, "EI", 2, "rhoA", 0.7, "rhoI", 0.01, "damping", 0.03, ...
                     "curvature", curvature, "curvature_breaks", [], "half_height", [], "width", []);
  body.tip_mass = 0.4;
  body.model = struct ("energy", "uniaxial", "rotary_inertia", true);
  model = free_rod_model (body, struct ("sines", [2 3], "stiffening", "exact"));
  at = @(s) sin ((1:8).'*[1 2] + s)/2;
  motion = motion_of_rods (at (0), at (1));
  gravity = 9.81;
endfunction

%!test # two along, three across, phi, x and y, in two states
%! [model, motion, gravity] = sample_exact_rod (1.1);
%! assert (size (motion.V), [5 2]); assert (columns (model.line.turn), 5); assert (gravity, 9.81);
