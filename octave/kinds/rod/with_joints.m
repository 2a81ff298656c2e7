## -*- texinfo -*-
## @deftypefn {} {[@var{loads}, @var{taken}, @var{dissipated}] =} with_joints (@var{loads}, @var{t}, @var{motion}, @
##   @var{c})
## The @var{loads} of a rod (see @code{loads_of_rod}) with the forces of its joints in the @var{motion} at the times
## @var{t} (see @code{pull_of_joints}), the power that springs and dampers take, which is no work of the loads, and
## what dampers dissipate of it (W, 1-by-k; 0 without joints).  @var{c} comes from @code{rod_constants}.
## @end deftypefn

function [loads, taken, dissipated] = with_joints (loads, t, motion, c)
  taken = dissipated = 0;
  if (! isempty (c.joined))
    pull = pull_of_joints (t, motion, c.joined);
    loads.work_V += pull.V;
    loads.work_phi += pull.phi;
    taken = pull.taken;
    dissipated = pull.dissipated;
  endif
endfunction

%!test
%! spring = struct ("kind", "torsion_spring", "stations", 0, "stiffness", 5, "damping", 2);
%! [scene, model] = sample_rod ([0 0], "joints", {spring});
%! motion = struct ("V", zeros (0, 1), "V_dot", zeros (0, 1), "phi", 0.5, "phi_dot", 3);
%! loads = struct ("work_V", zeros (0, 1), "work_phi", 1);
%! [loads, taken, dissipated] = with_joints (loads, 0, motion, rod_constants (scene, model));
%! assert (loads.work_phi, 1 - (5*0.5 + 2*3), 1e-14);
%! assert ([taken, dissipated], [5*0.5*3 + 2*9, 2*9], 1e-13);
