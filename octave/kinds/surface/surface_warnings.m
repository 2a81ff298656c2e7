## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} surface_warnings (@var{scene}, @var{history}, @var{strain})
## What is to be said of the motion of a rod on a surface (see @code{measure_surface}), a cellstr: where the surface
## would have to pull the rod, or its tip mass, and a @var{strain} (see @code{limit_warnings}) that is too large.
## @end deftypefn

function warnings = surface_warnings (scene, history, strain)
  warnings = {};
  push = scene.surface.side*history.reaction;
  [least, k] = min (min (push, [], 1));
  if (least < -1e-6*max (abs (push(:))))
    first = find (min (push, [], 1) < -1e-6*max (abs (push(:))), 1);
    warnings = {sprintf(["the surface would have to pull the rod from t = %.4g s on, by up to %.3g N/m at" ...
                         " t = %.4g s: a rod on one side would lift off there; surface.side = 0 has a rod" ...
                         " that cannot"], history.t(first), -least, history.t(k))};
  endif
  [least, k] = min (scene.surface.side*history.tip_reaction);
  if (any (least < -1e-6*max ([abs(history.tip_reaction(:)); scene.tip_mass*abs(scene.gravity)])))
    warnings{end+1} = sprintf (["the surface would have to pull the tip mass, by up to %.3g N at t = %.4g s: one on" ...
                                " one side would lift off; surface.side = 0 has one that cannot"], -least, ...
                               history.t(k));
  endif
  warnings = [warnings, limit_warnings(strain, "", "")];
endfunction

%!test # a sphere's inside turns a tip mass: m v^2/r, and its weight
%! scene = struct ("surface", struct ("name", "sphere", "radius", 1, "side", -1), "duration", 0.002, "tip_mass", 2, ...
%!                 "rod", struct ("length", 0.1, "EA", 3e3, "EI", 0.1, "EI_normal", 0, "rhoA", 1e-3), ...
%!                 "model", struct ("modes", [4 4]));
%! scene.initial.velocity = @(xi, alpha) [0*xi; 5 + 0*xi];
%! history = driver (scene, "output", "").history;
%! assert (history.tip_reaction(1), 2*5^2 + 2*9.81*cos (0.1), 1);
%!test # a rod flung over a hill would lift off
%! scene = struct ("surface", struct ("name", "sphere", "radius", 1, "side", -1), "duration", 0.02, ...
%!                 "rod", struct ("length", 0.1, "EA", 3e3, "EI", 0.1, "EI_normal", 0, "rhoA", 1.5), ...
%!                 "model", struct ("modes", [4 4]));
%! scene.initial.velocity = @(xi, alpha) [0.2 + 0*xi; 0*xi];
%! result = driver (scene, "output", "");
%! assert (! isempty (strfind (result.summary.warnings{1}, "would have to pull the rod from t = 0 s on")));
%! assert (driver (setfield (scene, "surface", "side", 1), "output", "").summary.warnings, {});
%!test # when it would lift off, and by how much; strains beyond a twentieth
%! scene = struct ("surface", struct ("side", 1), "tip_mass", 1, "gravity", 9.81);
%! said = @(reaction, tip, strain) surface_warnings (scene, struct ("t", [0 1 2], "reaction", reaction, ...
%!   "tip_reaction", tip), struct ("what", "axial strain", "limit", 0.05, "reached", strain));
%! assert (said ([1 1 1; 2 -1e-7 1], zeros (0, 3), 0.05), {});
%! assert (said ([0 0 0], zeros (0, 3), 0.05), {});
%! assert (! isempty (strfind (said ([1 1 1], [1 -3 2], 0){1}, "pull the tip mass, by up to 3 N at t = 1 s")));
%! assert (said ([1 1 1], [1 -1e-9 1]*1e-8, 0), {});
%! assert (! isempty (strfind (said ([1 -2 1; 2 1 -3], zeros (0, 3), 0){1}, "from t = 1 s on, by up to 3 N/m at t = 2 s:")));
%! assert (numel (said ([1 1 1], zeros (0, 3), 0.06)), 1);
