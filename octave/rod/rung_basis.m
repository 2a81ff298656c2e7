## -*- texinfo -*-
## @deftypefn {} {@var{basis} =} rung_basis (@var{rung}, @var{arrays}, @var{base}, @var{clamped}, @
##   @var{stiffness_of_joints})
## The basis (N-by-n) of the amplitudes V = basis*q on a @var{rung}: the paper's sines as they are, or the lowest
## eigenmodes of the linear system that the @var{arrays} of the @var{base} functions make.
##
## Of so many longitudinal functions the first are the elongations by forces that @var{base} has (see
## @code{elongation_numbers}), less what the eigenmodes among the others have of them.
##
## The bending modes are those of the rod and phi together, free to turn, or with the tangent at O held where
## @var{clamped}.  Joints with a stiffness, (N+1)-by-(N+1) in (V, phi) (default: none), bend the modes: of those of a
## rod that turns, the amplitudes V are taken, but where a mode is hardly more than phi.  Each has the largest
## amplitude 1.
## @end deftypefn

function basis = rung_basis (rung, arrays, base, clamped, stiffness_of_joints = [])
  N1 = numel (base.longitudinal);
  N = rows (arrays.mass_matrix);
  i1 = 1:N1;
  i2 = N1+1:N;
  if (! isempty (rung.sines))
    basis = eye (N);
    if (! strcmp (rung.axial, "dynamic"))
      basis(:,i1) = [];
    endif
    return;
  endif
  phi_of_V = -arrays.coupling_vector(i2)/arrays.moment_of_inertia;
  if (clamped)
    phi_of_V = -arrays.slope_2(i2);
  endif
  P = [eye(numel (i2)); phi_of_V.'];
  mass = mass_with_rotation (arrays)([i2, N + 1],[i2, N + 1]);
  longitudinal = 0;
  if (strcmp (rung.axial, "dynamic"))
    longitudinal = rung.longitudinal;
  endif
  along = longitudinal_modes_of (base, arrays.mass_matrix(i1,i1), arrays.stiffness_matrix(i1,i1), longitudinal);
  stiffness = blkdiag (arrays.stiffness_matrix(i2,i2), 0);
  if (! isempty (stiffness_of_joints))
    stiffness += stiffness_of_joints([i2, N + 1],[i2, N + 1]);
  endif
  if (isempty (stiffness_of_joints) || clamped)
    across = lowest_modes (P.'*mass*P, P.'*stiffness*P, rung.bending);
  else
    across = modes_that_bend (mass, stiffness, base.length, rung.bending);
  endif
  basis = blkdiag (along, across);
endfunction

## the rod's own lowest frequency, or what joints leave of it, moves a mode without stiffness away from 0
function modes = modes_that_bend (mass, stiffness, length, n)
  modes = zeros (rows (mass) - 1, n);
  if (n == 0)
    return;
  endif
  shift = min ((diag (stiffness)./diag (mass))(1:end-1));
  modes = lowest_modes (mass, stiffness + shift*mass, n + 1);
  V = modes(1:end-1,:);
  bent = max (abs (V), [], 1) > 1e-6*length*abs (modes(end,:));
  modes = V(:,bent)(:,1:n);
  modes ./= max (abs (modes), [], 1);
endfunction

function modes = longitudinal_modes_of (base, mass, stiffness, n)
  elongations = eye (rows (mass))(:,base.longitudinal < 0)(:,1:min (n, end));
  modes = lowest_modes (mass, stiffness, n - columns (elongations));
  rest = elongations - modes*((modes.'*stiffness*modes) \ (modes.'*stiffness*elongations));
  modes = [rest*lowest_modes(rest.'*mass*rest, rest.'*stiffness*rest, columns (rest)), modes];
endfunction

function modes = lowest_modes (mass, stiffness, n)
  scale = diag (1./sqrt (diag (stiffness)));
  [modes, flexibilities] = free_modes (scale*mass*scale, scale*stiffness*scale);
  [~, order] = sort (flexibilities, "descend");
  modes = scale*modes(:,order(1:min (n, end)));
  modes ./= max (abs (modes), [], 1);
endfunction

%!function omega = clamped_frequencies (rung, section, numbers)
%!  base = base_functions ([], numbers, 1);
%!  arrays = rod_arrays (base, section, 0);
%!  arrays.slope_2 = functions_across (base);
%!  B = rung_basis (rung, arrays, base, true);
%!  a = project_arrays (arrays, B);
%!  mass = a.mass_matrix - a.coupling_vector*a.slope_2.' - a.slope_2*a.coupling_vector.' ...
%!         + a.moment_of_inertia*a.slope_2*a.slope_2.';
%!  omega = sqrt (sort (eig (a.stiffness_matrix, mass)))/sqrt (7/3);
%!endfunction
%!function slopes = functions_across (base)
%!  [~, slopes] = functions_at (base, 0, 1);
%!  slopes = slopes.';
%!endfunction
%!test # clamped and free beam: beta l = 1.875104, 4.694091; without the function for the end moment it is far off
%! section = struct ("rhoA", 3, "rhoI", 0, "EA", 5, "EI", 7, "GI", 0);
%! rung = struct ("sines", [], "bending", 2, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! deviation = @(numbers) clamped_frequencies (rung, section, numbers)./[1.875104; 4.694091].^2 - 1;
%! assert (abs (deviation ([1:30, -1])) < 2e-6);
%! assert (deviation (1:30)(1) > 1e-2);
%!test # elongation by a force at the tip, whatever the number of functions: F l/EA; and they are orthogonal
%! section = struct ("rhoA", 3, "rhoI", 0, "EA", 5, "EI", 7, "GI", 0);
%! base = base_functions ([1:30, -1], [], 2);
%! for n = [1 2 9 31]
%!   rung = struct ("sines", [], "bending", 0, "longitudinal", n, "axial", "dynamic", "stiffening", "none");
%!   arrays = rod_arrays (base, section, 0);
%!   B = rung_basis (rung, arrays, base, false);
%!   a = project_arrays (arrays, B);
%!   assert (columns (B), n); assert (max (abs (B), [], 1), ones (1, n), 1e-9);  # a function's own size
%!   assert (a.stiffness_matrix, diag (diag (a.stiffness_matrix)), 1e-9*norm (a.stiffness_matrix));
%!   assert (a.mass_matrix, diag (diag (a.mass_matrix)), 1e-9*norm (a.mass_matrix));
%!   along = functions_at (base, [0.5; 2])*B;
%!   assert (along*(a.stiffness_matrix \ along(2,:).'), [0.5; 2]/5, 1e-12);
%! endfor
%!test # a torsion spring of a rigid rod, and of one that bends: k = EI/l (see linear_rod.m)
%! scene = struct ("rod", struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1), "duration", 1);
%! scene.model = struct ("energy", "uniaxial", "rotary_inertia", false);
%! scene = check_scene (setfield (scene, "joints", struct ("kind", "torsion_spring", "stations", 0, "stiffness", 1)));
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "foreshortening");
%! assert (highest_frequency (rod_system (scene, build_model (scene, rung))), sqrt (3), 1e-6);
%! system = rod_system (scene, build_model (scene, setfield (rung, "bending", 1)));
%! [~, squares] = free_modes (system.stiffness, system.mass);
%! assert (sqrt (squares(1)), 1.55729786, 1e-6);
