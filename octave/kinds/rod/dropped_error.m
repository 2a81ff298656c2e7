## -*- texinfo -*-
## @deftypefn {} {@var{dropped} =} dropped_error (@var{scene}, @var{model}, @var{history})
## How far a straight rod's centreline is from that of the geometrically exact rod because of what the whole family of
## models drops beyond foreshortening: a struct of metres (at most), x and y (by how much, 21 stations by frames, m)
## and bound (m).  It is the difference of the run of @var{history} (see @code{measure}) from one with the forces of
## what is dropped (see @code{with_dropped}).
##
## Where slope^2 and the strain times the deflection times a quarter of the phase through which modes and rotation go
## is below a fifth of the tolerance, that bound is enough: x and y are 0 then, and otherwise the bound is.  A rod that
## cannot be integrated so is bounded by its own length.
## @end deftypefn

function dropped = dropped_error (scene, model, history)
  stations = linspace (0, model.length, 21);
  x = y = zeros (21, numel (history.t));
  metres = bound (scene, model, history);
  dropped = struct ("metres", metres, "x", x, "y", y, "bound", metres);
  if (metres < scene.solver.tolerance/5)
    return;
  endif
  try
    system = with_dropped (scene, model);
    solver = struct ("name", "auto", "tolerance", scene.solver.tolerance/5);
    moved = measure (system, model, history.t, integrate (system, history.t, solver));
  catch err
    rethrow_others (err, "toolchain:integration");
    dropped.metres = dropped.bound = model.length;
    return;
  end_try_catch
  [own_x, own_y] = centreline (model, stations, history, 1);
  [exact_x, exact_y] = centreline (model, stations, moved, 1);
  [nearer_x, nearer_y] = rod_centreline (moved.phi(ones (21, 1),:), 0, ...
                                          -dropped_shortening (model, stations, moved.V), 0);
  dropped.x = exact_x + nearer_x - own_x;
  dropped.y = exact_y + nearer_y - own_y;
  dropped.metres = max (hypot (dropped.x, dropped.y)(:));
  dropped.bound = 0;
endfunction

function metres = bound (scene, model, history)
  slopes_of = largest_slopes (model);
  [slope, strain] = slopes_of (history.V);
  [~, deflections] = functions_at (model.base, linspace (0, model.length, 101));
  largest = max (abs (deflections*model.basis), [], 1).'.*max (abs (history.q), [], 2);
  omega = sqrt (diag (model.arrays.stiffness_matrix)./diag (model.arrays.mass_matrix));
  phase = (omega + max (abs (history.phi_dot)))*scene.duration;
  metres = (slope^2 + strain)*sum (largest.*(1 + phase/4));
endfunction

%!function [dropped, scene, history, model] = of_spin_up (tolerance, duration)
%!  scene = check_scene (setfield (setfield (spin_up (), "solver", "tolerance", tolerance), "duration", duration));
%!  rung = struct ("sines", [], "bending", 3, "longitudinal", 0, "axial", "none", "stiffening", "foreshortening");
%!  trial = trial_run (scene, rung);
%!  [history, model] = deal (trial.history, trial.model);
%!  dropped = dropped_error (scene, model, history);
%!endfunction
%!test # Kane's spin-up: the exact rod's tip is 0.573835 m behind the hub's line at 6.762 s, the family's 0.5706 m
%! [dropped, scene, history, model] = of_spin_up (1e-4, 6.8);
%! theta = arrayfun (@(t) scene.rotation (t)(1), history.t);
%! behind = @(x, y) max (x.*sin (theta) - y.*cos (theta));
%! assert (behind (history.tip_x, history.tip_y), 0.5706, 1e-4);
%! assert (behind (history.tip_x + dropped.x(end,:), history.tip_y + dropped.y(end,:)), 0.573835, 2e-4);
%! assert (dropped.metres, 3.2e-3, 0.3e-3);
%!test # of what hardly bends a bound is enough
%! dropped = of_spin_up (1e-4, 0.5);
%! assert (dropped.bound > 0 && dropped.bound < 2e-5 && dropped.metres == dropped.bound);
%! assert (! any (dropped.x(:)));
%!test # the bound holds where a rod bends little and is stretched more, which changes its frequencies
%! scene = struct ("rod", struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1), "gravity", 0, "duration", 2, ...
%!                 "initial", struct ("V2", 1e-3), "force", @(t) [10 0], "model", struct ("energy", "uniaxial"));
%! rung = struct ("sines", [], "bending", 2, "longitudinal", 1, "axial", "dynamic", "stiffening", "foreshortening");
%! scene = check_scene (setfield (scene, "solver", "tolerance", 1e-7));
%! trial = trial_run (scene, rung);
%! computed = dropped_error (scene, trial.model, trial.history);
%! bounded = dropped_error (setfield (scene, "solver", "tolerance", 1), trial.model, trial.history);
%! assert (computed.bound, 0); assert (bounded.bound, bounded.metres);
%! assert (computed.metres > 1e-6);
%! assert (computed.metres < bounded.metres && bounded.metres < 2*computed.metres);
%!test # a blow that modes along the rod answer, too: the exact rod (26 + 26 polynomials) is 4e-5 m away
%! scene = check_scene (setfield (setfield (hammer (), "duration", 0.003), "solver", "tolerance", 1e-4));
%! rung = struct ("sines", [], "bending", 11, "longitudinal", 4, "axial", "dynamic", "stiffening", "foreshortening");
%! trial = trial_run (scene, rung);
%! metres = dropped_error (scene, trial.model, trial.history).metres;
%! assert (metres > 2e-5 && metres < 8e-5);
