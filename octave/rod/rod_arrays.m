## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} rod_arrays (@var{base}, @var{section}, @var{shortening})
## The coefficient arrays of a straight hinged rod with the base functions @var{base} (see @code{base_functions}), in
## the order V = (V1; V2) of (16).
##
## Fields, with n base functions: mass_matrix, gyroscopic_matrix, centrifugal_matrix (n-by-n, kg), stiffness_matrix
## (n-by-n, N/m), shortened_moment_matrix (n-by-n, kg/m), coupling_vector, centrifugal_vector (n-by-1, kg m),
## first_moment_1, first_moment_2 (n-by-1, kg), moment_of_inertia (kg m^2), static_moment (kg m), mass (kg).
## @var{section} comes from @code{rod_section}; @var{shortening} is 1 with foreshortening, 0 without.
## @end deftypefn

function arrays = rod_arrays (base, section, shortening)
  rhoA = section.rhoA;
  rhoI = section.rhoI;
  length = base.length;
  j1 = base.longitudinal(:);
  j2 = base.transversal(:);
  N1 = numel (j1);
  N2 = numel (j2);
  [k11, j11] = meshgrid (j1, j1);
  [k12, j12] = meshgrid (j2, j1);
  [k22, j22] = meshgrid (j2, j2);

  mass_longitudinal = rod_mass_longitudinal (j11, k11, length, rhoA, rhoI);
  arrays.mass_matrix = blkdiag (mass_longitudinal, rod_mass_transversal (j22, k22, length, rhoA, rhoI));
  gyroscopic = rod_gyroscopic (j12, k12, length, rhoA, rhoI);
  arrays.gyroscopic_matrix = [zeros(N1), gyroscopic; -gyroscopic.', zeros(N2)];
  arrays.centrifugal_matrix = blkdiag (mass_longitudinal, ...
    rod_centrifugal_matrix_transversal (j22, k22, length, rhoA, rhoI, shortening));
  arrays.coupling_vector = [zeros(N1, 1); rod_coupling(j2, length, rhoA, rhoI)];
  arrays.centrifugal_vector = [rod_centrifugal(j1, length, rhoA, rhoI); zeros(N2, 1)];
  arrays.mass = rod_mass (length, rhoA);
  arrays.moment_of_inertia = rod_moment_of_inertia (length, rhoA, rhoI);
  arrays.stiffness_matrix = blkdiag (rod_stiffness_longitudinal (j11, k11, length, section.EA, section.GI),
                                     rod_stiffness_transversal (j22, k22, length, section.EI));
  arrays.static_moment = rod_static_moment (length, rhoA);
  arrays.first_moment_1 = [rod_first_moment_longitudinal(j1, length, rhoA); zeros(N2, 1)];
  arrays.first_moment_2 = [zeros(N1, 1); rod_first_moment_transversal(j2, length, rhoA)];
  arrays.shortened_moment_matrix = shortening*blkdiag (zeros (N1), rod_shortened_moment (j22, k22, length, rhoA));
  ## (-1)^j of the whole numbers has an imaginary part of rounding where others stand beside them
  arrays = structfun (@real, arrays, "uniformoutput", false);
endfunction

%!shared arrays, section
%! section = struct ("rhoA", 3, "rhoI", 0.01, "EA", 5, "EI", 7, "GI", 0);
%! arrays = rod_arrays (base_functions (1:2, 1:3, 1.5), section, 0);
%!assert (arrays.mass_matrix, arrays.mass_matrix.')
%!assert (arrays.gyroscopic_matrix, -arrays.gyroscopic_matrix.')
%!assert (arrays.centrifugal_matrix, arrays.mass_matrix, 1e-15)
%!assert (arrays.mass, 3*1.5, 1e-12)
%!assert (arrays.moment_of_inertia, 3*1.5^3/3 + 0.01*1.5, 1e-12)
%!assert (arrays.static_moment, 3*1.5^2/2, 1e-12)
%!test # coefficients are integrals over the length
%! f = @(x) sin (3*pi*x/3); g = @(x) sin (2*pi*x/1.5);
%! f_slope = @(x) pi*cos (3*pi*x/3); g_slope = @(x) 2*pi/1.5*cos (2*pi*x/1.5);
%! expected = -quadgk (@(x) 3*f(x).*g(x) + 0.01*f_slope(x).*g_slope(x), 0, 1.5);
%! assert (arrays.gyroscopic_matrix(2, 4), expected, 1e-9);
%!test # the elongation by a force within the rod, whose number is not whole, leaves all real
%! beside = rod_arrays (base_functions ([-0.7 1 2], 1:3, 1.5), section, 0);
%! assert (structfun (@isreal, beside));
%! assert (beside.mass_matrix(2:end,2:end), arrays.mass_matrix, 1e-14);
%! assert (beside.centrifugal_vector(2:end), arrays.centrifugal_vector, 1e-14);
%! assert (beside.gyroscopic_matrix(2:end,2:end), arrays.gyroscopic_matrix, 1e-14);
%!test # no modes at all
%! none = rod_arrays (base_functions ([], [], 1.5), section, 1);
%! assert (size (none.mass_matrix), [0 0]); assert (size (none.coupling_vector), [0 1]);
%!test # more modes leave the first ones alone
%! small = rod_arrays (base_functions ([], 1:3, 1.5), section, 0);
%! assert (small.stiffness_matrix, arrays.stiffness_matrix(3:5,3:5), 1e-12);

%!function S = simpson (a, b, x)
%!  weights = ones (numel (x), 1); weights(2:2:end-1) = 4; weights(3:2:end-2) = 2;
%!  S = (a.*weights*(x(2) - x(1))/3).'*b;
%!endfunction

%!test # with corrections for end moments, each array is the integral that it stands for
%! l = 1.5; numbers = [1 2 5 -1 -2]; x = linspace (0, l, 20001).'; n = numel (numbers);
%! [j, X] = meshgrid (numbers, x);
%! f = rod_shape_transversal (j, X, l); s = rod_slope_transversal (j, X, l); c = rod_curvature_transversal (j, X, l);
%! integral = @(a, b) simpson (a, b, x);
%! those = rod_arrays (base_functions ([], numbers, l), section, 1);
%! assert (those.mass_matrix, 3*integral (f, f) + 0.01*integral (s, s), 1e-7);
%! assert (those.stiffness_matrix, 7*integral (c, c), 1e-4);
%! assert (those.coupling_vector, 3*integral (f, x) + 0.01*integral (s, ones (size (x))), 1e-7);
%! assert (those.first_moment_2, 3*integral (f, ones (size (x))), 1e-7);
%! assert (those.shortened_moment_matrix, 3*integral (s.*(l - x), s), 1e-6);
%! tension = 3*(l^2 - x.^2)/2 + 0.01;
%! assert (those.mass_matrix - those.centrifugal_matrix, integral (s.*tension, s), 1e-6);
