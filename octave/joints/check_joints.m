## -*- texinfo -*-
## @deftypefn {} {@var{joints} =} check_joints (@var{given}, @var{of_bodies}, @var{names})
## The joints of a scene with all their fields (see @code{joint_fields}), those @var{given}, checked, and defaults for
## the others: a struct array in which the bodies are two numbers (0: the ground), the stations two (m), constant
## says whether the value is numbers, and value_name what messages call it.  @var{of_bodies} are the checked bodies, a
## struct array with the field rod; @var{names}, "joints" or a cell array, is what @code{take_list} takes.
## @end deftypefn

function joints = check_joints (given, of_bodies, names = "joints")
  joints = take_list (given, joint_fields (), names, "joint", ...
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
    joint.stations(k) = station_on_rod (sprintf ("%s.stations(%d)", what, k), joint.stations(k), ...
                                        of_bodies(on(k)).rod.length, sprintf ("body %d", on(k)));
  endfor
  joint.stations = [joint.stations(:).', 0](1:2);
  if (numel (joint.point) != 2)
    scene_error ("%s.point has %d numbers: it takes [x y] in m", what, numel (joint.point));
  endif
  if (strcmp (joint.kind, "bushing") && joint.rest != 0)
    scene_error ("%s.rest is %g: a bushing holds its points together, its rest is 0", what, joint.rest);
  endif
  joint.constant = isnumeric (joint.value);
  joint.value_name = value_name (what);
endfunction

%!test # messages call a value as the scene does
%! joint = struct ("kind", "moment", "bodies", 1, "stations", 0);
%! bodies = struct ("rod", struct ("length", 1));
%! assert ({check_joints({joint, joint}, bodies).value_name}, {"joints(1).value", "joints(2).value"});
%! assert ({check_joints({joint, joint}, bodies, {"moment", "joints(1)"}).value_name}, {"moment", "joints(1).value"});
%!test # the ground may go without saying
%! bodies = struct ("rod", {struct("length", 1), struct("length", 2)});
%! joints = check_joints ({struct("kind", "revolute", "bodies", 2, "stations", 2)}, bodies);
%! assert (joints.bodies, [2 0]); assert (joints.stations, [2 0]); assert (joints.name, "joint 1");
%!error <joints\(1\).point has 3 numbers: it takes \[x y\] in m>
%! joint = struct ("kind", "revolute", "bodies", 1, "stations", 0, "point", [1 2 3]);
%! check_joints ({joint}, struct ("rod", struct ("length", 1)));
