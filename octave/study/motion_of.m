## -*- texinfo -*-
## @deftypefn {} {@var{motion} =} motion_of (@var{result})
## Where the points of all centrelines are in all frames of a @var{result} of @code{driver}, of any kind: a struct of x
## and y, and z on a surface (points-by-frames, m): 21 points of one rod, 11 of each body, 101 on a surface.
## @end deftypefn

function motion = motion_of (result)
  if (isfield (result, "mechanism"))
    [motion.x, motion.y] = deal ([]);
    for k = 1:numel (result.history.bodies)
      model = result.mechanism.models{k};
      [x, y] = body_centreline (model, linspace (0, model.length, 11), result.history.bodies(k), 1);
      [motion.x, motion.y] = deal ([motion.x; x], [motion.y; y]);
    endfor
  elseif (isfield (result.scene, "surface"))
    motion = struct ("x", result.history.x, "y", result.history.y, "z", result.history.z);
  else
    [motion.x, motion.y] = centreline (result.model, linspace (0, result.model.length, 21), result.history, 1);
  endif
endfunction

%!test # the tips are the last points
%! result = driver (setfield (chain (2), "duration", 0.04), "output", "");
%! motion = motion_of (result);
%! assert (motion.x([11 22],:), [result.history.bodies(1).tip_x; result.history.bodies(2).tip_x], 1e-12);
%! result = driver (setfield (paper (), "duration", 0.04), "modes", [0 1], "output", "");
%! assert (motion_of (result).y(end,:), result.history.tip_y, 1e-12);
%! result = driver (setfield (large_swing (), "duration", 0.04), "modes", [4 4], "output", "");
%! assert (motion_of (result).z(end,:), result.history.tip(3,:), 1e-12);
