## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} exact_kind ()
## The geometrically exact rod in the plane, among the kinds of scenes (see @code{kind_of}): a rod on the upright plane
## that @code{exact_scene} has made of one straight rod, with the columns and points of a rod in the plane: phi is the
## angle of a hub, or that of a hinged rod's models, of the line from O to the tip.
## @end deftypefn

function kind = exact_kind ()
  kind = surface_kind ();
  kind.name = "exact";
  upright = struct ("name", "plane", "inclination", pi/2, "side", 0);
  kind.has = @(given) isfield (given, "exact") && isfield (given, "surface") && isequal (given.surface, upright);
  kind.check = @(given) setfield (check_surface_scene (rmfield (given, "exact")), "exact", given.exact);
  kind.far_richer = @(scene, model) min (model.numbers.modes + 4, 32);  # a smooth rod's error falls by powers
  kind.observe = @observe_exact;
  kind.describe = @describe_exact;
  kind.columns = @exact_columns;
  kind.drawing = @exact_drawing;
  kind.panels = @(scene, run) in_the_plane (surface_kind ().panels (scene, run));
  kind.turning = @steady_exact;
  kind.of_exact = @(scene) exact_kind ();
endfunction

function turning = steady_exact (scene)
  if (isempty (scene.rotation))
    scene_error ("no steady rotation: the geometrically exact rod turns in a hub, or, as a body, about its joint");
  endif
  turning = steady_surface (scene);
endfunction

function run = observe_exact (scene, model, system, times, states)
  run = surface_kind ().observe (scene, model, system, times, states);
  history = run.history;
  [history.tip_x, history.tip_y] = deal (history.tip(1,:), history.tip(3,:));
  [history.mid_x, history.mid_y] = deal (history.mid(1,:), history.mid(3,:));
  if (isempty (scene.rotation))
    [z, z_dot] = deal (states(1:system.n,:), states(system.n+1:2*system.n,:));
    tip = system.fields (times, z, z_dot, z_dot, scene.rod.length);
    [history.phi, history.phi_dot] = line_to_tip (tip.alpha1, tip.alpha2, tip.alpha1_dot, tip.alpha2_dot, scene.exact);
  else
    turned = at_times (scene.rotation, times);
    [history.phi, history.phi_dot] = deal (turned(1,:), turned(2,:));
  endif
  [run.x, run.y] = deal (run.x(1:5:end,:), run.z(1:5:end,:));
  run = rmfield (run, "z");
  run.history = history;
endfunction

function own = describe_exact (scene, run)
  own = surface_kind ().describe (scene, run);
  own.model = sprintf ("geometrically exact, %d + %d polynomials", own.modes);
endfunction

function drawing = exact_drawing (scene, run)
  drawing = surface_kind ().drawing (scene, run);
  drawing.strips = in_the_plane (drawing.strips);
endfunction

function panels = in_the_plane (panels)
  tip = strcmp ({panels.label}, "tip");
  panels(tip).names = strrep (panels(tip).names, "z", "y");
endfunction

## the plane's second direction is upwards; what is across the plane is left out
function [names, table] = exact_columns (scene, run)
  [names, table] = surface_columns (scene, run);
  words = strtok (names, " ");
  across = ismember (words, {"tip_y", "mid_y", "reaction_y", "angular_momentum_x", "angular_momentum_y", ...
                             "angular_momentum_z", "smallest_reaction", "largest_reaction", "tip_reaction"});
  names = [regexprep(names(! across), '^(tip|mid|reaction)_z', '$1_y'), {"phi [rad]", "phi_dot [rad/s]"}];
  table = [table(! across,:); run.history.phi; run.history.phi_dot];
endfunction

%!function [names, table, result, panels] = written (scene, exact)
%!  evalc ("result = driver (scene, 'output', '', 'exact', exact, 'tolerance', 1e-5);");
%!  kind = kind_of (result.scene);
%!  [names, table] = kind.columns (result.scene, result);
%!  panels = kind.panels (result.scene, result);
%!endfunction
%!test # its columns are those of the rod in the plane, and the same motion
%! scene = setfield (setfield (swing (), "duration", 0.05), "frames_per_second", 100);
%! [names, table, result, panels] = written (scene, true);
%! [plane_names, plane_table] = written (scene, false);
%! for name = {"t [s]", "tip_x [m]", "tip_y [m]", "psi [rad]", "mid_y [m]", "tip_psi [rad]", "reaction_x [N]", "T [J]", ...
%!             "phi [rad]", "phi_dot [rad/s]"}
%!   values = table(strcmp (names, name{1}),:);
%!   assert (values, plane_table(strcmp (plane_names, name{1}),:), 1e-3*max (abs (values)) + 1e-9);
%! endfor
%! assert (result.summary.model(1:19), "geometrically exact"); assert (panels(1).names, {"x", "y"});
%! assert (any (strncmp (names, "reaction_y", 10))); assert (! any (strncmp (names, "tip_z", 5)));
%! hub = struct ("rod", struct ("length", 1, "EA", 1e5, "EI", 10, "rhoA", 0.1), "duration", 0.02, ...
%!               "rotation", @(t) [0.2 + 3*t^2, 6*t, 6]);
%! [names, table] = written (hub, true);
%! t = table(1,:);
%! assert (table(strncmp (names, "phi", 3),:), [0.2 + 3*t.^2; 6*t], 1e-12);
%!error <exact is not a field of a scene on a surface>
%! scene = struct ("name", "sphere", "radius", 1);
%! driver (struct ("surface", scene, "rod", struct ("length", 1), "duration", 1, "exact", true), "output", "");
%!error <exact is not a field> driver (setfield (swing (), "exact", true), "output", "")
%!error <the geometrically exact rod turns in a hub, or, as a body>
%! exact_kind ().turning (exact_scene (check_scene (swing ())));
