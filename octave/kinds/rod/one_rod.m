## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} one_rod (@var{given})
## Whether a scene, checked or not, is of one rod by itself: without joints, or, where it is straight, with springs and
## loads, and dampers that leave its modes apart (see @code{dampers_couple}).
## @end deftypefn

function yes = one_rod (given)
  yes = ! any (isfield (given, {"bodies", "pieces"}));
  if (yes && isfield (given, "joints"))
    yes = isfield (given, "rod") && (isempty (given.joints) || (! is_curved (given) && are_forces (given.joints) ...
                                                               && ! dampers_couple (given)));
  endif
endfunction

%!test # a spring, a slider, and a spring on an arc
%! spring = struct ("kind", "spring", "stations", 0.2, "point", [0 1], "stiffness", 3);
%! scene = setfield (swing (), "joints", {spring});
%! assert (one_rod (scene), true);
%! assert (one_rod (setfield (scene, "joints", {struct("kind", "slider", "stations", 0.2)})), false);
%! assert (one_rod (setfield (scene, "rod", "curvature", 1)), false);
%! assert (one_rod (setfield (setfield (scene, "rod", "curvature", 1), "joints", {})), true);
%! assert ([one_rod(chain (2)), one_rod(setfield (scene, "pieces", 2)), one_rod(struct ())], [false false true]);
