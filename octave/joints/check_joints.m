## -*- texinfo -*-
## @deftypefn {} {@var{joints} =} check_joints (@var{given}, @var{of_bodies})
## The joints of a scene with all their fields (see @code{joint_fields}), those @var{given}, checked, and defaults for
## the others: a struct array in which the bodies are two numbers (0: the ground), the stations two (m) and constant
## says whether the value is numbers.  @var{of_bodies} are the checked bodies, a struct array with the field rod.
## @end deftypefn

function joints = check_joints (given, of_bodies)
  joints = take_list (given, joint_fields (), "joints", "joint", ...
                      @(joint, what) check_joint (joint, what, of_bodies));
endfunction

function joint = check_joint (joint, what, of_bodies)
  bodies = joint.bodies(:).';
  if (! any (numel (bodies) == [1 2]) || any (bodies != fix (bodies)) || bodies(1) < 1 || any (bodies < 0) ...
      || any (bodies > numel (of_bodies)) || (numel (bodies) == 2 && bodies(1) == bodies(2)))
    scene_error ("%s.bodies is [%s]: it takes a body's number from 1 to %d, and another's or 0 for the ground", ...
                 what, num2str (bodies), numel (of_bodies));
  endif
  joint.bodies = [bodies, 0](1:2);
  on = joint.bodies(joint.bodies > 0);
  if (numel (joint.stations) != numel (on))
    scene_error ("%s.stations are [%s]: it takes a station on each of its %d bodies", what, ...
                 num2str (joint.stations(:).'), numel (on));
  endif
  for k = 1:numel (on)
    length = of_bodies(on(k)).rod.length;
    if (abs (joint.stations(k) - length) < 1e-9*length)
      joint.stations(k) = length;  # but for rounding
    endif
    if (joint.stations(k) < 0 || joint.stations(k) > length)
      scene_error ("%s.stations(%d) is %g: body %d has places from 0 to %g m", what, k, joint.stations(k), ...
                   on(k), length);
    endif
  endfor
  joint.stations = [joint.stations(:).', 0](1:2);
  if (numel (joint.point) != 2)
    scene_error ("%s.point has %d numbers: it takes [x y] in m", what, numel (joint.point));
  endif
  if (strcmp (joint.kind, "bushing") && joint.rest != 0)
    scene_error ("%s.rest is %g: a bushing holds its points together, its rest is 0", what, joint.rest);
  endif
  joint.constant = isnumeric (joint.value);
endfunction

%!test # the ground may go without saying
%! bodies = struct ("rod", {struct("length", 1), struct("length", 2)});
%! joints = check_joints ({struct("kind", "revolute", "bodies", 2, "stations", 2)}, bodies);
%! assert (joints.bodies, [2 0]); assert (joints.stations, [2 0]); assert (joints.name, "joint 1");
%!error <joints\(1\).point has 3 numbers: it takes \[x y\] in m>
%! joint = struct ("kind", "revolute", "bodies", 1, "stations", 0, "point", [1 2 3]);
%! check_joints ({joint}, struct ("rod", struct ("length", 1)));
