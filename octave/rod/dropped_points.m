## -*- texinfo -*-
## @deftypefn {} {@var{points} =} dropped_points (@var{model}, @var{rod})
## The points of a straight rod at which @code{dropped_forces} takes what its @var{model} drops: those of Gauss on
## equal panels, as many as its modes need, and the tip.
##
## Fields, for p points and n coordinates q: xi1 (p-by-1, m), rhoA, rhoI and EI (p-by-1: mass, rotary inertia and
## stiffness times length of the part of the rod that a point stands for), force_share (p-by-1: 1 where
## @var{rod}.force_station is), along and across (cell arrays of p-by-n: v1 = along@{1@}*q, its first and second
## derivatives, and those of v2), of_followers (cell array of p-by-N1, likewise), stretch_at_O, slope_at_O (1-by-n) and
## integral (p-by-p: of values at the points from O to each), and axis (as @code{integrals_to} takes it).  @var{rod}
## has tip_mass (kg) and force_station (m).
## @end deftypefn

function points = dropped_points (model, rod)
  length = model.length;
  axis = panels_between (linspace (0, length, 3 + ceil (columns (model.basis)/3)));
  stations = [axis.xi, rod.force_station, length];
  points.axis = axis;
  points.xi1 = stations.';
  section = model.section;
  per_length = [axis.weights, 0, 0].';
  points.rhoA = section.rhoA*per_length;
  points.rhoA(end) = rod.tip_mass;
  points.rhoI = section.rhoI*per_length;
  points.EI = section.EI*per_length;
  points.force_share = [zeros(size (axis.xi)), 1, 0].';
  points.integral = [integrals_to(axis, stations), zeros(numel (stations), 2)];
  N1 = numel (model.base.longitudinal);
  for k = 1:3
    [along, across] = functions_at (model.base, stations, k - 1);
    points.along{k} = along*model.basis;
    points.across{k} = across*model.basis;
    points.of_followers{k} = along(:,1:N1);
  endfor
  [stretch, slope] = functions_at (model.base, 0, 1);
  points.stretch_at_O = stretch*model.basis;
  points.slope_at_O = slope*model.basis;
endfunction

%!test # mass, stiffness and shortening of a half wave
%! [scene, model] = sample_rod ([0 1], "tip_mass", 3);
%! points = dropped_points (model, scene);
%! assert (sum (points.rhoA), 7800*6e-4 + 3, 1e-12);
%! assert (points.across{3}.'*(points.EI.*points.across{3}), model.arrays.stiffness_matrix, 1e-9*model.section.EI);
%! assert (points.integral(end,:)*points.across{2}.^2, pi^2/2, 1e-12);
