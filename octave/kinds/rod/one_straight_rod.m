## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} one_straight_rod (@var{given})
## Whether a scene, not checked yet, with joints is of one rod whose joints are springs and loads, with dampers that leave
## its modes apart (see @code{dampers_couple}); a curved one may have none.
## @end deftypefn

function yes = one_straight_rod (given)
  straight = isfield (given, "rod") && ! (isfield (given.rod, "curvature") && ! isempty (given.rod.curvature));
  yes = isfield (given, "rod") && (isempty (given.joints) || (straight && are_forces (given.joints) ...
                                                             && ! dampers_couple (given)));
endfunction

%!test # a spring, a slider, and a spring on an arc
%! spring = struct ("kind", "spring", "stations", 0.2, "point", [0 1], "stiffness", 3);
%! scene = setfield (swing (), "joints", {spring});
%! assert (one_straight_rod (scene), true);
%! assert (one_straight_rod (setfield (scene, "joints", {struct("kind", "slider", "stations", 0.2)})), false);
%! assert (one_straight_rod (setfield (scene, "rod", "curvature", 1)), false);
%! assert (one_straight_rod (setfield (setfield (scene, "rod", "curvature", 1), "joints", {})), true);
