## -*- texinfo -*-
## @deftypefn {} {@var{hinges} =} pins_of_joints (@var{joints}, @var{x}, @var{y})
## Those of the @var{joints}, whose points are at @var{x}, @var{y} (joints-by-m, m), that hold a point, and where
## springs and bushings are held by the ground, as @code{draw_pictures} takes hinges: a struct of x, y, ground and
## shape.
## @end deftypefn

function hinges = pins_of_joints (joints, x, y)
  shapes = struct ("revolute", "pin", "position", "pin", "bushing", "pin", "weld", "weld", "slider", "block");
  pinned = find (arrayfun (@(joint) isfield (shapes, joint.kind), joints(:).'));
  gives = @(joint) any (strcmp (joint.kind, {"spring", "bushing"}));
  on_ground = arrayfun (@(joint) gives (joint) && joint.bodies(2) == 0, joints(:).');
  feet = vertcat (zeros (0, 2), joints(on_ground).point);
  same = ones (1, columns (x));
  hinges = struct ("x", [x(pinned,:); feet(:,1).*same], "y", [y(pinned,:); feet(:,2).*same]);
  moves = @(joint) gives (joint) || strcmp (joint.kind, "slider");
  hinges.ground = arrayfun (@(joint) joint.bodies(2) == 0 && ! moves (joint), joints(pinned)(:));
  hinges.ground = [hinges.ground; true(rows (feet), 1)];
  hinges.shape = arrayfun (@(joint) shapes.(joint.kind), joints(pinned)(:), "uniformoutput", false);
  hinges.shape = [hinges.shape; repmat({"pin"}, rows (feet), 1)];
endfunction

%!test
%! joints = struct ("kind", {"spring", "bushing", "spring"}, "bodies", {[1 0], [1 0], [1 2]}, "point", [3 4]);
%! hinges = pins_of_joints (joints, [1; 2; 9], [5; 6; 9]);
%! assert ([hinges.x, hinges.y], [2 6; 3 4; 3 4]); assert (hinges.ground, [false; true; true]);
%! assert (hinges.shape, {"pin"; "pin"; "pin"});
