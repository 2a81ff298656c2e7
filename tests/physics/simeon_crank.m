## -*- texinfo -*-
## @deftypefn {} {@var{state} =} simeon_crank (@var{changes}, @var{tolerance})
## The slider-crank "crank" of the Test Set for IVP Solvers (Mazzia and Magherini; B. Simeon, Math. Modelling of
## Systems 2, 1996) at t = 0.1 s, to a @var{tolerance} (m): [phi; x; q1; q2; q3; q4] (6-by-1), the rod's angle (rad),
## the block's place and the amplitudes (m).  The @var{changes} (a cell of names) lead from its model to that of the
## scene slider_crank, and further:
##
## @table @asis
## @item pi, axial mass, J2
## pi of all digits; the axial block of the mass matrix as derived, 1/15 of the 8, 1, 1, 2 there; no rotary inertia in
## J2
## @item sines
## our coefficient arrays (see @code{simeon_arrays}): sines along the rod, not quadratic elements
## @item start
## from the undeformed rod, not from the quasi-stationary state printed there
## @item rotary inertia, foreshortening, modes
## of all of the section; of the bent rod; and 4 + 4 modes
## @end table
## @end deftypefn

function state = simeon_crank (changes, tolerance)
  has = @(name) any (strcmp (name, changes));
  [scene, mechanism, along] = crank (has);
  system = mechanism_system (scene, mechanism);
  start = assemble_mechanism (scene, mechanism, system);
  rod = index_of (mechanism, 2);
  if (! has ("start"))
    axial = along(:,1:2) \ [0.103339863e-4, -0.178591076e-5; 0.169327969e-4, -0.268938672e-5];
    others = zeros (numel (rod) - 7, 1);
    start.q(rod) = [axial(:,1); others; 0; 0; 0; 0.15; 0];
    start.v(rod) = [axial(:,2); others(1:end/2); 0.444896105; 0.463434311e-2; others(1:end/2); -74.9957670; 0; 22.5];
    start.v = project_velocities (system, 0, start.q, start.v);
  endif
  states = integrate_constrained (system, [0 0.1], start, struct ("name", "radau", "tolerance", tolerance));
  q = states.q(:,2);
  at = markers_of_states (mechanism, q, 0*q);
  V = q(rod(1:end-3));
  bending = V(end/2 + [1 2]);
  state = [q(rod(end-2)); at.x(mechanism.marker_of(4,1)); bending; along*V];
endfunction

## along: u (l/2) and u (l) by the amplitudes
function [scene, mechanism, along] = crank (has)
  scene = load_scene ("slider_crank");
  scene.bodies{2}.rod.rhoI = 7870*0.008^4/12;
  scene.bodies{2}.model.rotary_inertia = has ("rotary inertia");
  scene.bodies{2}.model.stiffening = "none";
  if (has ("foreshortening"))
    scene.bodies{2}.model.stiffening = "foreshortening";
  endif
  scene.bodies{2}.model.modes = [2 2];
  if (has ("modes"))
    scene.bodies{2}.model.modes = [4 4];
  endif
  scene = check_mechanism (scene);
  mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
  base = mechanism.models{2}.base;
  along = functions_at (base, base.length*[0.5 1]);
  if (! has ("sines"))
    [mechanism, along] = simeon_arrays (mechanism, has);
  endif
endfunction

%!test # as printed there
%! assert (simeon_crank ({}, 1e-8), crank_differences ("printed"), 1e-8);
