## -*- texinfo -*-
## @deftypefn {} {@var{basis} =} rung_basis (@var{rung}, @var{arrays}, @var{N1}, @var{clamped})
## The basis (N-by-n) of the amplitudes V = basis*q on a @var{rung}: the paper's sines as they are, or the lowest
## eigenmodes of the linear system that the @var{arrays} make, the first @var{N1} of which are longitudinal.
##
## The bending modes are those of the rod and phi together, free to turn, or with the tangent at O held where
## @var{clamped}.  Each has the largest amplitude 1.
## @end deftypefn

function basis = rung_basis (rung, arrays, N1, clamped)
  N = rows (arrays.mass_matrix);
  [i1, i2] = deal (1:N1, N1+1:N);
  dynamic = strcmp (rung.axial, "dynamic");
  if (! isempty (rung.sines))
    basis = eye (N)(:,[repmat(i1, 1, dynamic), i2]);
    return;
  endif
  coupling = arrays.coupling_vector(i2);
  phi_of_V = -coupling/arrays.moment_of_inertia;
  if (clamped)
    phi_of_V = -arrays.slope_2(i2);
  endif
  P = [eye(numel (i2)); phi_of_V.'];
  mass = P.'*[arrays.mass_matrix(i2,i2), coupling; coupling.', arrays.moment_of_inertia]*P;
  along = lowest_modes (arrays.mass_matrix(i1,i1), arrays.stiffness_matrix(i1,i1), dynamic*rung.longitudinal);
  basis = blkdiag (along, lowest_modes (mass, arrays.stiffness_matrix(i2,i2), rung.bending));
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
%!  B = rung_basis (rung, arrays, 0, true);
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
