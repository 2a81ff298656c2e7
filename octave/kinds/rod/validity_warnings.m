## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} validity_warnings (@var{scene}, @var{model}, @var{history})
## Where a run leaves what its model holds for: a cellstr of warnings with numbers and remedies.  Looked at are the
## slope v2,1 and the strain (see @code{rod_limits}), the rate of rotation against the first frequency of the simply
## supported rod, the times of the loads' changes against the highest mode, and the drawn slope at the scene's zoom.
## @end deftypefn

function warnings = validity_warnings (scene, model, history)
  limits = rod_limits (scene, model, history);
  warnings = [limit_warnings(limits, "", "take a stiffer rod or smaller loads"), ...
              drawing_warning(scene, limits(1).reached), ...
              spin_warning(scene, model, max (abs (history.phi_dot))), spectrum_warning(scene, model)];
endfunction

## a zoomed rod that crosses itself on pictures
function warnings = drawing_warning (scene, slope)
  warnings = {};
  if (scene.zoom*slope > 3)
    warnings = {sprintf(["the drawn slope reaches %.3g at zoom %g, so that the drawn rod may cross itself:" ...
                         " take a zoom of %.2g"], scene.zoom*slope, scene.zoom, 3/slope)};
  endif
endfunction

## changes of the moment faster than the highest bending mode's period: where a quarter of it sees less than the change
function warnings = spectrum_warning (scene, model)
  warnings = {};
  breaks = unique ([0, scene.breaks(:).']);
  a = model.arrays;
  if (isempty (scene.breaks) || rows (a.mass_matrix) == 0 || isempty (model.rung.sines))
    return;
  endif
  highest = sqrt (max (diag (a.stiffness_matrix)./diag (a.mass_matrix)));
  shortest = min (diff (breaks));
  if (2*pi/shortest > highest)
    warnings = {sprintf(["a load changes within %.2g s, its spectrum reaches %.3g rad/s, beyond the highest mode" ...
                         " at %.3g rad/s: take more modes, or model.modes = \"auto\""], ...
                        shortest, 2*pi/shortest, highest)};
  endif
endfunction

%!function warnings = of_paper (zoom, V, phi_dot)
%!  [scene, model] = sample_rod ([0 1], "zoom", zoom);
%!  warnings = validity_warnings (scene, model, struct ("V", V, "phi_dot", phi_dot));
%!endfunction
%!assert (of_paper (300, 1e-4, 1), {})
%!test
%! warnings = of_paper (300, 0.1, 400);
%! assert (regexp (warnings{1}, "slope v2,1 reaches 0.31, .* 0.05;"), 5);
%! assert (! isempty (regexp (warnings{2}, "at zoom 300, .* take a zoom of 9.5")));
%! assert (! isempty (regexp (warnings{3}, "phi_dot reaches 400 rad/s, .* 51\\d rad/s: .*foreshortening")));
%!test # a load that ends soon after its begin
%! [scene, model] = sample_rod ([0 1]);
%! said = @(breaks) validity_warnings (setfield (scene, "breaks", breaks), model, struct ("V", 0, "phi_dot", 0));
%! assert (said (1), {}); assert (strncmp (said (1e-4), "a load changes within 0.0001 s, its spectrum reaches", 50));
%!test # a drawn slope of 3 is where it begins: pi*zoom/10
%! assert (cellfun (@(zoom) numel (of_paper (zoom, 0.1, 1)), {9.54, 9.56}), [1 2]);
