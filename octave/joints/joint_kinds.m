## -*- texinfo -*-
## @deftypefn {} {@var{kinds} =} joint_kinds ()
## The kinds of joints: a struct array of name, constraints (functions of generated/, one a scalar constraint), springs
## (likewise, of the elongations of what has an energy and no constraint), loads (which of F_x, F_y, M are its value),
## values (how many numbers its value has in the plane), sees (what it sees of its bodies: points, tangents).  A joint
## acts between its first body and its second, or the ground.
##
## @table @code
## @item revolute
## The points of both stay together.
## @item weld
## The points and the tangents of both stay together, as they begin.
## @item slider
## The point of the first stays on the line through the point of the second along its tangent, or along
## direction on the ground.
## @item angle
## The first tangent is turned against the second (or the ground) by the value: a number, or [a a_dot a_ddot] of t.
## @item position
## The point of the first is off that of the second by the value: [x y], or [x y; x_dot y_dot; x_ddot y_ddot] of t.
## @item spring, torsion_spring
## A spring and damper between both points, or both tangents: stiffness, damping, rest.
## @item bushing
## A spring and damper, of the same stiffness and damping in all directions, holds both points together.
## @item moment, force
## The value, M or [F_x F_y], a number or a function of t, acts on the first and against the second.
## @end table
## @end deftypefn

function kinds = joint_kinds ()
  x = @constraint_horizontal;
  y = @constraint_vertical;
  a = @constraint_angle;
  rows = {
    "revolute",       {x, y},             {},              [], 0, {"point"}
    "weld",           {x, y, a},          {},              [], 0, {"point", "tangent"}
    "slider",         {@constraint_line}, {},              [], 0, {"point", "tangent"}
    "angle",          {a},                {},              [], 1, {"tangent"}
    "position",       {x, y},             {},              [], 2, {"point"}
    "spring",         {},                 {@constraint_distance}, [], 0, {"point"}
    "torsion_spring", {},                 {a},             [], 0, {"tangent"}
    "bushing",        {},                 {x, y},          [], 0, {"point"}
    "moment",         {},                 {},              3,  1, {"tangent"}
    "force",          {},                 {},              [1 2], 2, {"point"}
  };
  kinds = cell2struct (rows, {"name", "constraints", "springs", "loads", "values", "sees"}, 2).';
endfunction

%!assert (numel (joint_kind ("weld").constraints), 3)
