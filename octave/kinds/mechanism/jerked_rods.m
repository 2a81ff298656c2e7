## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} jerked_rods (@var{scene}, @var{constraints}, @var{off})
## A cellstr with a warning for each joint of a checked @var{scene} that drives rods which bend from the start on, where
## these are not stated to move so: they begin with a jerk.  @var{off} (constraints-by-1) is by how much the rates of
## the @var{constraints} (see @code{list_constraints}) are not those of the stated start.
## @end deftypefn

function warnings = jerked_rods (scene, constraints, off)
  warnings = {};
  for kind = constraints.kinds
    for row = reshape (kind.rows(kind.moving), 1, [])
      joint = scene.joints(constraints.joint(row));
      on = scene.bodies(joint.bodies(joint.bodies > 0));
      bends = any (arrayfun (@(body) ! isequal (body.model.modes(:), [0; 0]), on));
      if (bends && abs (off(row)) > 1e-9)
        warnings{end+1} = sprintf (["%s drives from the start on, by %.3g (rad/s or m/s) faster than its bodies are" ...
                                    " stated to move: rods that bend begin with a jerk, initial.phi_dot (x_dot," ...
                                    " y_dot) with its motion"], joint.name, abs (off(row)));
      endif
    endfor
  endfor
endfunction

%!function warnings = of_motor (modes, phi_dot)   # at 2 rad/s
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 10, "rhoA", 1), ...
%!                         "model", struct ("modes", modes), "initial", struct ("phi_dot", phi_dot))};
%!  joint = @(kind, varargin) struct ("kind", kind, "bodies", 1, "stations", 0, varargin{:});
%!  scene.joints = {joint("revolute"), joint("angle", "name", "motor", "value", @(t) [2*t, 2, 0])};
%!  scene.duration = 1;
%!  [~, warnings] = assembled (scene, 1);
%!  warnings = warnings(strncmp (warnings, "motor", 5));
%!endfunction
%!test # a rod that bends, unless it is stated to move; not a rigid one
%! assert (of_motor ([0 1], 0), {["motor drives from the start on, by 2 (rad/s or m/s) faster than its bodies are" ...
%!   " stated to move: rods that bend begin with a jerk, initial.phi_dot (x_dot, y_dot) with its motion"]});
%! assert ([numel(of_motor ([0 1], 2)), numel(of_motor ([0 0], 0))], [0 0]);
