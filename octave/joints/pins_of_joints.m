## -*- texinfo -*-
## @deftypefn {} {@var{hinges} =} pins_of_joints (@var{joints}, @var{x}, @var{y}, @var{angle})
## Those of the @var{joints}, whose points are at @var{x}, @var{y} (joints-by-m, m) and whose guides or tangents are at
## an @var{angle} (rad), that hold a point, and where springs and bushings are held by the ground, as
## @code{draw_pictures} takes hinges: a struct of x, y, angle, ground and shape.
## @end deftypefn

function hinges = pins_of_joints (joints, x, y, angle)
  shapes = struct ("revolute", "pin", "position", "pin", "bushing", "pin", "weld", "weld", "slider", "block");
  pinned = find (arrayfun (@(joint) isfield (shapes, joint.kind), joints(:).'));
  gives = @(joint) any (strcmp (joint.kind, {"spring", "bushing"}));
  on_ground = arrayfun (@(joint) gives (joint) && joint.bodies(2) == 0, joints(:).');
  feet = vertcat (zeros (0, 2), joints(on_ground).point);
  same = ones (1, columns (x));
  ends = arrayfun (@(joint) strcmp (joint.kind, "weld") && joint.stations(1) > 0, joints(:));
  angle(ends,:) += pi;  # what holds them is beyond them
  hinges = struct ("x", [x(pinned,:); feet(:,1).*same], "y", [y(pinned,:); feet(:,2).*same], ...
                   "angle", [angle(pinned,:); 0*feet(:,1).*same]);
  moves = @(joint) gives (joint) || strcmp (joint.kind, "slider");
  hinges.ground = arrayfun (@(joint) joint.bodies(2) == 0 && ! moves (joint), joints(pinned)(:));
  hinges.ground = [hinges.ground; true(rows (feet), 1)];
  hinges.shape = arrayfun (@(joint) shapes.(joint.kind), joints(pinned)(:), "uniformoutput", false);
  hinges.shape(arrayfun (@(joint) is_turned (joint, joints), joints(pinned)(:))) = {"hub"};
  hinges.shape = [hinges.shape; repmat({"pin"}, rows (feet), 1)];
endfunction

## a hinge on the ground whose angle another joint prescribes there
function yes = is_turned (hinge, joints)
  there = @(joint) isequal (joint.bodies, hinge.bodies) && isequal (joint.stations, hinge.stations);
  turns = @(joint) strcmp (joint.kind, "angle") && there (joint);
  yes = strcmp (hinge.kind, "revolute") && hinge.bodies(2) == 0 && any (arrayfun (turns, joints));
endfunction

%!test
%! joints = struct ("kind", {"spring", "bushing", "spring"}, "bodies", {[1 0], [1 0], [1 2]}, "point", [3 4], ...
%!                  "stations", [0 0]);
%! hinges = pins_of_joints (joints, [1; 2; 9], [5; 6; 9], [7; 8; 9]);
%! assert ([hinges.x, hinges.y, hinges.angle], [2 6 8; 3 4 0; 3 4 0]); assert (hinges.ground, [false; true; true]);
%! assert (hinges.shape, {"pin"; "pin"; "pin"});
%!test # what an angle turns is a hub, and only there
%! joints = struct ("kind", {"revolute", "angle", "revolute", "slider"}, "bodies", {[1 0], [1 0], [2 0], [1 0]}, ...
%!                  "stations", [0 0], "point", [0 0]);
%! assert (pins_of_joints (joints, [1; 1; 2; 1], [1; 1; 2; 1], zeros (4, 1)).shape, {"hub"; "pin"; "block"});
%!test # the wall of a weld at a rod's other end is beyond it
%! joint = struct ("kind", "weld", "bodies", [1 0], "stations", [2 0], "point", [0 0]);
%! assert (pins_of_joints (joint, 0, 0, 0.5).angle, pi + 0.5);
