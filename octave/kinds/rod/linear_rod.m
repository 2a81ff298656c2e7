## -*- texinfo -*-
## @deftypefn {} {[@var{stiffness}, @var{damping}] =} linear_rod (@var{phi}, @var{c})
## The stiffness and damping matrix, (n+1)-by-(n+1) in (V, phi), of the undeformed rod at the angle @var{phi}, without
## its weight, with its joints at the start; @var{c} comes from @code{rod_constants}.
## @end deftypefn

function [stiffness, damping] = linear_rod (phi, c)
  stiffness = blkdiag (c.rod.stiffness_matrix, 0);
  damping = c.rod.damping*stiffness;
  if (! isempty (c.joined))
    [K, D] = tangent_of_joints (0, zeros (rows (stiffness) - 1, 1), phi, c.joined);
    stiffness += (K + K.')/2;
    damping += (D + D.')/2;
  endif
endfunction

%!function off = from_frequencies (modes, k)   # of a pinned rod with a torsion spring k EI/L at the hinge
%!  torsion = struct ("kind", "torsion_spring", "stations", 0, "stiffness", k);
%!  rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1);
%!  scene = struct ("rod", rod, "gravity", 0, "duration", 1, "joints", {{torsion}});
%!  scene.model = struct ("energy", "uniaxial", "rotary_inertia", false);
%!  scene = check_scene (scene);
%!  rung = struct ("sines", [], "bending", modes, "longitudinal", 0, "axial", "none", "stiffening", "none");
%!  system = rod_system (scene, build_model (scene, rung));
%!  [~, squares] = free_modes (system.stiffness, system.mass);
%!  off = sqrt (squares(1:2)) - exact (k);
%!endfunction
%!function omega = exact (k)
%!  ## of a free end: b (cosh b sin b - sinh b cos b) = k (1 + cosh b cos b)
%!  f = @(b) b*(cosh (b)*sin (b) - sinh (b)*cos (b)) - k*(1 + cosh (b)*cos (b));
%!  omega = [fzero(f, [0.1 2]); fzero(f, [3 4.7])].^2;
%!endfunction
%!test # k = EI/L: 1.5573, 16.2501 (Hodges and Pierce 2011, Tables 3.10 and 3.11); and weak and stiff ones
%! assert (exact (1), [1.55729786; 16.2500852], 1e-7);
%! for k = [1e-3 1 1e3 1e6]
%!   assert (from_frequencies (3, k), [0; 0], 1e-6*exact (k));
%! endfor
