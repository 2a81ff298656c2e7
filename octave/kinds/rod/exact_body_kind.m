## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} exact_body_kind ()
## The geometrically exact rod as a body, among the kinds of scenes (see @code{kind_of}): the mechanism of one body
## that @code{exact_body} makes of a rod, with the columns and pictures of a rod.  phi of a curved one is the angle of
## the frame in which its points have no angular momentum about O, to the first order (see @code{curved_base}), that of
## a straight one the angle of the line from O to its tip.
## @end deftypefn

function kind = exact_body_kind ()
  kind = mechanism_kind ();
  kind.name = "exact body";
  kind.has = @(given) isfield (given, "exact") && isstruct (given.exact);
  kind.check = @refuse;
  kind.of_exact = @(exact) exact_body_kind ();
  kind.ladder = @ladder_of_polynomials;
  kind.observe = @observe_body;
  kind.describe = @describe_body;
  kind.columns = @(scene, run) rod_columns (scene.exact, run);
  kind.drawing = @(scene, run) rod_drawing (scene.exact, run.model.models{1}, run.history);
  kind.panels = @(scene, run) rod_panels (run.history, undeformed_tip (run.model.models{1}));
endfunction

function scene = refuse (given)
  scene = [];
  scene_error ("exact is not a field of a scene: EXACT=yes, or the option \"exact\", takes the geometrically exact rod");
endfunction

function ladder = ladder_of_polynomials (scene)
  ladder = mechanism_ladder (scene);
  ladder.name = @(rung) sprintf ("%d + %d polynomials", rung.longitudinal, rung.bending);
endfunction

## with what a rod's history has (see measure)
function run = observe_body (scene, model, system, times, states)
  run = mechanism_kind ().observe (scene, model, system, times, states);
  history = run.history;
  for name = {"phi", "phi_dot", "psi", "tip_psi", "V", "V_names", "tip_x", "tip_y", "mid_x", "mid_y"}
    history.(name{1}) = history.bodies.(name{1});
  endfor
  history.torque = [];
  if (! isempty (scene.exact.rotation))
    turned = at_times (scene.exact.rotation, times);
    [history.phi, history.phi_dot] = deal (turned(1,:), turned(2,:));
    history.torque = history.joints(2).torque;  # of the rotation, behind the hinge
  elseif (isempty (scene.exact.rod.curvature))
    [history.phi, history.phi_dot] = angle_of_tip (model.models{1}, named_rows (system, states), history.phi(1));
  endif
  [history.reaction_x, history.reaction_y] = deal (history.joints(1).reaction_x, history.joints(1).reaction_y);
  history.joint_points = [];
  run.history = history;
  [run.x, run.y] = body_centreline (model.models{1}, linspace (0, scene.exact.rod.length, 21), history.bodies, 1);
endfunction

function [phi, phi_dot] = angle_of_tip (rod, states, first)
  motion = motion_of_rods (states.q, states.v);
  [x, y, x_dot, y_dot] = rod.equations.point (motion, rod.equations.marker (rod, rod.length));
  [phi, phi_dot] = line_to_tip (x, y, x_dot, y_dot, first);
endfunction

function own = describe_body (scene, run)
  own = describe_mechanism (scene, run);
  rung = run.model.models{1}.rung;
  own.model = sprintf ("geometrically exact, %d + %d polynomials", rung.longitudinal, rung.bending);
  own.modes = [rung.longitudinal, rung.bending];
  own.stiffening = "exact";
endfunction

%!test # its columns and panels are those of the rod, with the same motion where it hardly bends
%! scene = setfield (setfield (arc_pendulum (), "duration", 0.1), "frames_per_second", 50);
%! [scene.rod.lambda, scene.rod.mu] = deal (1.2e14, 8.1e13);
%! for exact = [true false]
%!   evalc ("result = driver (scene, 'output', '', 'exact', exact, 'tolerance', 1e-5);");
%!   kind = kind_of (result.scene);
%!   [names{2-exact}, table{2-exact}] = kind.columns (result.scene, result);
%!   panels{2-exact} = kind.panels (result.scene, result);
%! endfor
%! for name = {"t [s]", "phi [rad]", "tip_x [m]", "psi [rad]", "mid_y [m]", "tip_psi [rad]", "T [J]"}
%!   values = table{1}(strcmp (names{1}, name{1}),:);
%!   assert (values, table{2}(strcmp (names{2}, name{1}),:), 1e-3*max (abs (values)) + 1e-9);
%! endfor
%! mean_of = @(k) mean (table{k}(strcmp (names{k}, "reaction_y [N]"),:));  # which rings
%! assert (mean_of (1), mean_of (2), 0.03*mean_of (2));
%! assert ({panels{1}(1:2).label}, {panels{2}(1:2).label});
%!error <exact is not a field of a scene> driver (setfield (arc_pendulum (), "exact", struct ()), "output", "")
%!assert ({exact_body_kind().of_exact([]).name, exact_kind().of_exact([]).name}, {"exact body", "exact"})
