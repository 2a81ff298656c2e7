## -*- texinfo -*-
## @deftypefn {} {[@var{base}, @var{arrays}] =} curved_base (@var{base}, @var{rod}, @var{section}, @var{energy}, @
##   @var{tip_mass})
## The @var{base} functions (see @code{base_functions}) of a straight rod as those of a curved one (see
## @code{curved_functions}): with its axis (see @code{rod_axis}) and turned, and their @var{arrays} (see
## @code{curved_arrays}).  @var{energy} is the scene's model.energy, @var{tip_mass} (kg) its own.  The stiffness of
## polynomials (see @code{strain_polynomials}) is that of EA and EI in any case.
##
## They are turned back so that they have no angular momentum (the frame of Tisserand): else they come near a rotation
## of the whole rod.  `make conditioning' shows what this makes of the mass matrix's condition.
## @end deftypefn

function [base, arrays] = curved_base (base, rod, section, energy, tip_mass = 0)
  if (! isempty (rod.EA) || ! strcmp (energy, "paper") || isfield (base, "polynomials"))
    by_section = [];
  else
    by_section = rod;
  endif
  most = max ([numel(base.longitudinal), numel(base.transversal)]);
  axis = rod_axis (rod, max (16, ceil (most/2)), section, tip_mass);
  arrays = curved_arrays (base, axis, section, by_section, tip_mass);
  base.axis = axis;
  base.turned = arrays.coupling_vector.'/arrays.moment_of_inertia;
  arrays = curved_arrays (base, axis, section, by_section, tip_mass);
endfunction

%!test # no angular momentum is left
%! scene = check_scene (arc_pendulum ());
%! section = rod_section (scene.rod, scene.model);
%! [base, arrays] = curved_base (base_functions (1:2, 1:3, scene.rod.length), scene.rod, section, "uniaxial");
%! assert (arrays.coupling_vector/arrays.moment_of_inertia, zeros (5, 1), 1e-12);
%!test # the frame's x axis goes through the centre of mass, of a thick rod too
%! rod = struct ("length", 2, "curvature", 1, "curvature_breaks", [], "EA", 1, "EI", 1);
%! section = struct ("rhoA", 3, "rhoI", 0.2, "EA", 1, "EI", 1);
%! a = curved_base (base_functions ([], 1, 2), rod, section, "uniaxial").axis;
%! [~, ~, S_2] = curved_rod_constants (a, section);
%! assert (S_2*a.weights.', 0, 1e-12);
