## -*- texinfo -*-
## @deftypefn {} {@var{joined} =} joined_rod (@var{model}, @var{joints})
## The rod of a @var{model} as its checked @var{joints} see it, which are springs and loads: a mechanism of one body
## whose O stays at the origin, with markers, springs and loads (see @code{list_markers} and @code{list_springs}), n,
## its number of coordinates (V; phi; x; y), of which x and y are 0, and length (m).  Empty without joints.
## @end deftypefn

function joined = joined_rod (model, joints)
  joined = [];
  if (isempty (joints))
    return;
  endif
  joined.n = columns (model.basis) + 3;
  joined.groups = struct ("model", model, "index", (1:joined.n).');
  joined.place = [1 1];
  joined.length = model.length;
  joined = list_markers (joined, joints);
  [joined.springs, joined.loads] = list_springs (joined, joints);
endfunction

%!test
%! spring = struct ("kind", {"spring", "force"}, "stations", {1, 0.5}, "point", [1 2], "value", {0, [3 4]});
%! [scene, model] = sample_rod ([1 2], "joints", spring);
%! joined = joined_rod (model, scene.joints);
%! assert (joined.n, 6); assert (joined.marker_count, 4); assert (joined.springs.count, 1);
%! assert (joined.loads.value (0), [3 4]);
%! assert (joined_rod (model, []), []);

%!function scene = swinging ()
%!  scene.rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1, "half_height", 0.005, "damping", 1e-3);
%!  scene.model = struct ("modes", [1 2], "energy", "uniaxial", "stiffening", "foreshortening");
%!  [scene.tip_mass, scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.3, 0.15, 20, 1e-11);
%!  joint = @(kind, station, varargin) struct ("kind", kind, "stations", station, varargin{:});
%!  scene.joints = {joint("torsion_spring", 0, "stiffness", 1, "damping", 0.01), ...
%!                  joint("spring", 0.5, "point", [0.5 1], "stiffness", 30, "rest", 0.9, "damping", 0.2), ...
%!                  joint("bushing", 1, "point", [1 0], "stiffness", 20, "damping", 0.1), ...
%!                  joint("force", 0.7, "value", @(t) [t, -1]), joint("moment", 1, "value", 0.3)};
%!endfunction
%!function compare (scene)   # with the same as a body of a mechanism: all that both observe
%!  assert (kind_of (scene).name, "rod");
%!  rod = driver (scene, "output", "").history;
%!  history = driver (as_bodies (scene), "output", "").history;
%!  for name = {"phi", "phi_dot", "psi", "tip_x", "tip_y", "V"}
%!    body = history.bodies.(name{1});
%!    assert (rod.(name{1}), body, 1e-9*max (abs (body(:))));
%!  endfor
%!  for name = {"reaction_x", "reaction_y"}  # of the hinge
%!    assert (rod.(name{1}), history.joints(1).(name{1}), 1e-6*max (abs (history.joints(1).(name{1}))));
%!  endfor
%!  for name = {"T", "U", "Z", "W", "D"}
%!    assert (rod.(name{1}), history.(name{1}), 1e-9*max (abs (history.(name{1}))) + 1e-15);
%!  endfor
%!endfunction
%!test # springs, dampers and loads at once, on a hinged rod and in a hub
%! compare (setfield (swinging (), "initial", struct ("phi_dot", 0.1)));
%! compare (setfield (swinging (), "rotation", @(t) [sin(t)-t, cos(t)-1, -sin(t)]));
%!test # a very stiff spring at the hinge is a hub at rest
%! scene = rmfield (swinging (), "joints");
%! scene.solver.tolerance = 1e-6;
%! tip = @(scene) driver (scene, "output", "").history.tip_y;
%! hub = tip (setfield (scene, "rotation", @(t) [0 0 0]));
%! spring = struct ("kind", "torsion_spring", "stations", 0, "stiffness", 1e7);
%! assert (tip (setfield (scene, "joints", spring)), hub, 1e-5);
%!test # a spring at the hinge and one to the ground at mid-span
%! scene = setfield (swinging (), "tip_mass", 0);
%! compare (setfield (scene, "joints", scene.joints(1:2)));
