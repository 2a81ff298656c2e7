## -*- texinfo -*-
## @deftypefn {} {@var{line} =} line_points (@var{base}, @var{rod}, @var{section}, @var{tip_mass})
## The geometrically exact rod at its points, those of Gauss on equal panels, as many as its polynomials and its
## undeformed shape need, cut where its curvature jumps, and the tip: how its strains and the integrals of its tangent
## follow from polynomials of a @var{base} with its axis (see @code{strain_polynomials} and @code{curved_base}).
##
## Fields, for p points and n amplitudes V: stretch, turn and bend (p-by-n, 1/m, 1/m, 1/m^2; of V), angle (p-by-1, rad,
## of the undeformed tangent in the rod's frame), offset (p-by-1, m, as @code{rod_exact_offset} takes it), to_points
## (p-by-p, m: of values at the points the integrals from O to each), axis (as @code{integrals_to} takes it) and points
## (a struct of point_mass, rotary_inertia, axial_stiffness and bending_stiffness, p-by-1, as @code{rod_exact_energies}
## takes them).
## @end deftypefn

function line = line_points (base, rod, section, tip_mass)
  n = numel (base.longitudinal) + numel (base.transversal);
  count = 1 + ceil (n/8);
  do
    line.axis = panels_between (unique ([linspace(0, base.length, count + 1), rod.curvature_breaks(:).']));
    count *= 2;
  until (follows (line.axis, base) || count > 128)
  stations = [line.axis.xi, base.length];
  f = curved_functions (base, base.axis, stations);
  line.stretch = f.e;
  line.turn = f.chi;
  line.bend = f.bend;
  [~, ~, angle] = undeformed_places (base, stations);
  line.angle = angle(:);
  kappa = curvature_at (setfield (rod, "length", base.length), stations)(:);
  [line.offset, rotary_inertia] = rod_section_mass (kappa, section);
  line.offset(end) = 0;  # of the tip mass
  line.to_points = [integrals_to(line.axis, stations), zeros(numel (stations), 1)];
  lengths = [line.axis.weights, 0].';
  line.points = struct ("point_mass", section.rhoA*lengths, "rotary_inertia", rotary_inertia.*lengths, ...
                        "axial_stiffness", section.EA*lengths, "bending_stiffness", section.EI*lengths);
  line.points.point_mass(end) = tip_mass;
endfunction

## whether integrals along these points have the undeformed rod where it is
function yes = follows (axis, base)
  [~, ~, angle] = undeformed_places (base, axis.xi);
  [x, y] = undeformed_places (base, axis.ends);
  off = integrals_to (axis, axis.ends)*exp (1i*angle).' - (x + 1i*y).';
  yes = norm (off, Inf) <= 1e-9*base.length;
endfunction

%!test # a straight rod with a mass at its tip
%! rod = struct ("length", 2, "curvature", [], "curvature_breaks", []);
%! section = struct ("rhoA", 3, "rhoI", 0.1, "EA", 7, "EI", 5);
%! base = setfield (base_functions (1:2, 1:3, 2), "polynomials", true);
%! base = curved_base (base, setfield (rod, "EA", 7), section, "uniaxial", 4);
%! line = line_points (base, rod, section, 4);
%! sums = structfun (@sum, line.points);
%! assert (sums.', [3*2+4, 0.1*2, 7*2, 5*2], 1e-13);
%! assert ((line.to_points*line.axis.xi([1:end, end]).')(end), 2, 1e-14);
%! assert (line.angle, zeros (numel (line.angle), 1));
%! assert (size (line.bend), [numel(line.angle), 5]);
%!test # a coil and a wave: as many points as have them where they are
%! section = struct ("rhoA", 1, "rhoI", 0, "EA", 7, "EI", 5);
%! for curvature = {40, @(xi) 10*cos(60*xi)}
%!   rod = struct ("length", 1, "curvature", curvature{1}, "curvature_breaks", [], "EA", 7);
%!   base = curved_base (setfield (base_functions (1, 1:3, 1), "polynomials", true), rod, section, "uniaxial", 0);
%!   line = line_points (base, rod, section, 0);
%!   [x, y] = undeformed_places (base, 1);
%!   assert (line.to_points(end,:)*exp (1i*line.angle), x + 1i*y, 1e-8);
%! endfor
