## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} rod_arrays (@var{modes}, @var{length}, @var{section})
## The coefficient arrays of a straight hinged rod with @var{modes} = [N1 N2] sines, in the order V = (V1; V2) of (16).
##
## Fields, with n = N1 + N2: mass_matrix, gyroscopic_matrix (n-by-n, kg), stiffness_matrix (n-by-n, N/m), coupling_vector,
## centrifugal_vector (n-by-1, kg m), first_moment_1, first_moment_2 (n-by-1, kg), moment_of_inertia (kg m^2),
## static_moment (kg m).  @var{length} is in m, @var{section} comes from @code{rod_section}.
## @end deftypefn

function arrays = rod_arrays (modes, length, section)
  [N1, N2] = deal (modes(1), modes(2));
  [rhoA, rhoI] = deal (section.rhoA, section.rhoI);
  j1 = (1:N1).';
  j2 = (1:N2).';
  [k11, j11] = meshgrid (j1, j1);
  [k12, j12] = meshgrid (j2, j1);
  [k22, j22] = meshgrid (j2, j2);

  arrays.mass_matrix = blkdiag (rod_mass_longitudinal (j11, k11, length, rhoA, rhoI),
                                rod_mass_transversal (j22, k22, length, rhoA, rhoI));
  gyroscopic = rod_gyroscopic (j12, k12, length, rhoA, rhoI);
  arrays.gyroscopic_matrix = [zeros(N1), gyroscopic; -gyroscopic.', zeros(N2)];
  arrays.coupling_vector = [zeros(N1, 1); rod_coupling(j2, length, rhoA, rhoI)];
  arrays.centrifugal_vector = [rod_centrifugal(j1, length, rhoA, rhoI); zeros(N2, 1)];
  arrays.moment_of_inertia = rod_moment_of_inertia (length, rhoA, rhoI);
  arrays.stiffness_matrix = blkdiag (rod_stiffness_longitudinal (j11, k11, length, section.EA, section.GI),
                                     rod_stiffness_transversal (j22, k22, length, section.EI));
  arrays.static_moment = rod_static_moment (length, rhoA);
  arrays.first_moment_1 = [rod_first_moment_longitudinal(j1, length, rhoA); zeros(N2, 1)];
  arrays.first_moment_2 = [zeros(N1, 1); rod_first_moment_transversal(j2, length, rhoA)];
endfunction

%!shared arrays, section
%! section = struct ("rhoA", 3, "rhoI", 0.01, "EA", 5, "EI", 7, "GI", 0);
%! arrays = rod_arrays ([2 3], 1.5, section);
%!assert (arrays.mass_matrix, arrays.mass_matrix.')
%!assert (arrays.gyroscopic_matrix, -arrays.gyroscopic_matrix.')
%!assert (arrays.moment_of_inertia, 3*1.5^3/3 + 0.01*1.5, 1e-12)
%!assert (arrays.static_moment, 3*1.5^2/2, 1e-12)
%!test # coefficients are integrals over the length
%! f = @(x) sin (3*pi*x/3); g = @(x) sin (2*pi*x/1.5);
%! f_slope = @(x) pi*cos (3*pi*x/3); g_slope = @(x) 2*pi/1.5*cos (2*pi*x/1.5);
%! expected = -quadgk (@(x) 3*f(x).*g(x) + 0.01*f_slope(x).*g_slope(x), 0, 1.5);
%! assert (arrays.gyroscopic_matrix(2, 4), expected, 1e-9);
%!test # no modes at all
%! arrays = rod_arrays ([0 0], 1.5, section);
%! assert (size (arrays.mass_matrix), [0 0]); assert (size (arrays.coupling_vector), [0 1]);
%!test # more modes leave the first ones alone
%! small = rod_arrays ([0 3], 1.5, section);
%! assert (small.stiffness_matrix, arrays.stiffness_matrix(3:5,3:5), 1e-12);
