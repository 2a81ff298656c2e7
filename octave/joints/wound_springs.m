## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} wound_springs (@var{joints}, @var{which}, @var{elongations})
## A cellstr with a warning for each torsion spring whose angle is more than half a turn from its rest: on a drawing,
## which does not tell turns, it may be at rest.  @var{elongations} (rad, or m) are those of the springs of the checked
## @var{joints} of the numbers @var{which} (k-by-1).
## @end deftypefn

function warnings = wound_springs (joints, which, elongations)
  warnings = {};
  for k = find (abs (elongations) > pi).'
    joint = joints(which(k));
    if (strcmp (joint.kind, "torsion_spring"))
      turns = 2*pi*round (elongations(k)/(2*pi));
      warnings{end+1} = sprintf (["%s begins %.3g rad from its rest, turns are counted: with rest = %.6g, the same" ...
                                  " direction, it begins %.3g rad from it"], ...
                                 joint.name, elongations(k), joint.rest + turns, elongations(k) - turns);
    endif
  endfor
endfunction

%!test # one of three that is a turn and more away; springs along a line may be as long
%! joints = struct ("kind", {"torsion_spring", "spring", "torsion_spring"}, "name", {"a", "b", "c"}, "rest", {1, 0, 0.5});
%! said = wound_springs (joints, [1; 2; 3], [3; 7; -6]);
%! assert (said, {["c begins -6 rad from its rest, turns are counted: with rest = -5.78319, the same direction, it" ...
%!                 " begins 0.283 rad from it"]});
