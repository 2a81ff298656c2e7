## -*- texinfo -*-
## @deftypefn {} {@var{points} =} points_of_joints (@var{joined}, @var{q}, @var{phi})
## Where the joints of a @code{joined_rod} hold it with the coordinates @var{q} (n-by-m) at the angles @var{phi}
## (1-by-m, rad), a struct of x and y (m; joints-by-m); empty of a rod without joints.
## @end deftypefn

function points = points_of_joints (joined, q, phi)
  points = [];
  if (! isempty (joined))
    places = marker_places (joined, [q; phi; zeros(2, columns (phi))]);
    points = struct ("x", places.x(joined.marker_of(:,1),:), "y", places.y(joined.marker_of(:,1),:));
  endif
endfunction

%!test
%! joint = struct ("kind", "moment", "stations", 0.5, "value", 1);
%! [scene, model] = sample_rod ([0 1], "joints", joint);
%! points = points_of_joints (joined_rod (model, scene.joints), [0 0.1], [0 pi/2]);
%! assert (points.x, [0.5 -0.1], 1e-14); assert (points.y, [0 0.5], 1e-14);
%! assert (points_of_joints ([], 0, 0), []);
