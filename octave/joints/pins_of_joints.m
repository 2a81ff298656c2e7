## -*- texinfo -*-
## @deftypefn {} {@var{hinges} =} pins_of_joints (@var{joints}, @var{x}, @var{y})
## Those of the @var{joints}, whose points are at @var{x}, @var{y} (joints-by-m, m), that hold a point, as
## @code{draw_pictures} takes hinges: a struct of x, y, ground and shape.
## @end deftypefn

function hinges = pins_of_joints (joints, x, y)
  shapes = struct ("revolute", "pin", "position", "pin", "bushing", "pin", "weld", "weld", "slider", "block");
  pinned = find (arrayfun (@(joint) isfield (shapes, joint.kind), joints(:).'));
  hinges = struct ("x", x(pinned,:), "y", y(pinned,:));
  hinges.ground = arrayfun (@(joint) joint.bodies(2) == 0 && ! strcmp (joint.kind, "slider"), joints(pinned)(:));
  hinges.shape = arrayfun (@(joint) shapes.(joint.kind), joints(pinned)(:), "uniformoutput", false);
endfunction

%!test
%! joints = struct ("kind", {"spring", "bushing"}, "bodies", [1 0]);
%! hinges = pins_of_joints (joints, [1; 2], [5; 6]);
%! assert ([hinges.x, hinges.y], [2 6]); assert (hinges.ground); assert (hinges.shape, {"pin"});
