## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} rotating_beam (@var{spin}, @var{n})
## In-plane frequencies of a hinged Euler-Bernoulli beam that spins freely at @var{spin}, the first @var{n} elastic
## ones, by Chebyshev collocation: w'''' - (T w')' - spin^2 w = omega^2 w, T = spin^2 (1 - x^2)/2, on a unit length
## with E I = rho A = 1.  (Flapping frequencies squared are larger by spin^2: Wright, Smith, Thresher and Wang, 1982.)
## @end deftypefn

function omega = rotating_beam (spin, n)
  N = 32;
  s = cos (pi*(0:N).'/N);
  c = [2; ones(N-1, 1); 2].*(-1).^(0:N).';
  S = repmat (s, 1, N + 1);
  D = (c*(1./c).')./(S - S.' + full (eye (N + 1)));
  D = 2*(D - diag (sum (D, 2)));
  x = (s + 1)/2;
  T = spin^2*(1 - x.^2)/2;
  [D2, D3, I] = deal (D^2, D^3, full (eye (N + 1)));
  A = D^4 - D*diag (T)*D - spin^2*I;
  B = I;
  ends = [1, 2, N, N + 1];
  A(ends,:) = [D2(1,:); D3(1,:); D2(N+1,:); I(N+1,:)];
  B(ends,:) = 0;
  squares = eig (A, B);
  physical = isfinite (squares) & abs (imag (squares)) < 1e-3*abs (squares) & abs (squares) < 1e6;
  squares = sort (real (squares(physical)));
  omega = sqrt (squares(squares > 1)(1:n));
endfunction

%!function omega = of_rod (spin, stiffening, n)
%!  rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.01);
%!  scene = check_scene (struct ("rod", rod, "duration", 1, "gravity", 0));
%!  rung = struct ("sines", [], "bending", 30, "longitudinal", 0, "axial", "none", "stiffening", stiffening);
%!  a = build_model (scene, rung).arrays;
%!  stiffness = rod_tangent_stiffness (struct ("phi", 0, "phi_dot", spin), a, 0);
%!  mass = a.mass_matrix - a.coupling_vector*a.coupling_vector.'/a.moment_of_inertia;
%!  omega = sort (sqrt (eig (stiffness, mass)))(1:n);
%!endfunction

%!test # without spin: beta l = 3.926602, 7.068583, 10.210176
%! assert (rotating_beam (0, 3), [3.926602; 7.068583; 10.210176].^2, 1e-4);
%!test # with foreshortening the rod has the frequencies of the rotating beam, to 0.1 %
%! for spin = [0 1 2 4 8 12]
%!   assert (of_rod (spin, "foreshortening", 3)./rotating_beam (spin, 3), ones (3, 1), 1e-3);
%! endfor
%!test # without it the first one falls to 0 at the first frequency pi^2 of the simply supported rod
%! lowest = @(spin) real (of_rod (spin, "none", 1)^2);
%! assert (fzero (lowest, [5 15]), pi^2, 1e-6*pi^2);
