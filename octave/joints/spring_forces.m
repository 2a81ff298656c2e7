## -*- texinfo -*-
## @deftypefn {} {@var{springs} =} spring_forces (@var{mechanism}, @var{at})
## The springs in the states that @var{at} came from (see @code{marker_motion}): what @code{joint_constraints} has of
## their elongations, and tension (N or N m), its derivatives stiffness and damping (springs-by-k), energy (J) and
## dissipated (W; 1-by-k).
## @end deftypefn

function springs = spring_forces (mechanism, at)
  every = ones (1, columns (at.x));
  list = mechanism.springs;
  springs = joint_constraints (list, prescribed_values (list, every), at);
  [energy, dissipated, springs.tension, springs.stiffness, springs.damping] = ...
    spring_law (springs.residual, springs.velocity, list.stiffness*every, list.damping*every);
  springs.energy = sum (energy, 1);
  springs.dissipated = sum (dissipated, 1);
endfunction

%!test # forces are the energy's gradients, less the dampers'
%! [system, q, v, h] = sample_state ();
%! of = @(s) spring_forces (system.mechanism, markers_of_states (system.mechanism, q + s*v, v));
%! at = system.at (0, q, v);
%! power = (of (h).energy - of (-h).energy)/(2*h) + at.springs.dissipated;
%! assert (system.spring_reaction (at, at.springs.tension).'*v, power, 1e-6);
%!test # and their tangents
%! [system, q, v, h] = sample_state ();
%! of = @(s, r) spring_forces (system.mechanism, markers_of_states (system.mechanism, q + s*v, v*(1 + r))).tension;
%! at = system.at (0, q, v);
%! [~, ~, jacobian] = system.matrices (at);
%! assert ((of (0, h) - of (0, -h))/(2*h), at.springs.damping.*(jacobian*v), 1e-6);
%! still = @(s) spring_forces (system.mechanism, markers_of_states (system.mechanism, q + s*v, 0*v)).tension;
%! assert ((still (h) - still (-h))/(2*h), at.springs.stiffness.*(jacobian*v), 1e-6);
%!test # at two times they are those of each
%! [system, q, v] = sample_state ();
%! of = @(q, v) spring_forces (system.mechanism, markers_of_states (system.mechanism, q, v));
%! [both, first, second] = deal (of ([q, 1.01*q], [v, -v]), of (q, v), of (1.01*q, -v));
%! for name = {"tension", "stiffness", "damping", "energy", "dissipated"}
%!   assert (both.(name{1}), [first.(name{1}), second.(name{1})], 1e-12*norm (both.(name{1})));
%! endfor
