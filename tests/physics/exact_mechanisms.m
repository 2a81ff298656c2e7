## -*- texinfo -*-
## @deftypefn {} {@var{run} =} exact_mechanisms (@var{scene}, @var{rung})
## The run of a @var{scene} of bodies, not checked yet, all of them geometrically exact, on a @var{rung} ([longitudinal,
## bending] polynomials of each), for the tests of this file.
## @end deftypefn

function run = exact_mechanisms (scene, rung)
  kind = mechanism_kind ();
  scene = exact_bodies (kind.check (scene));
  each = ones (1, numel (scene.bodies));
  run = run_model (kind, scene, kind.build (scene, struct ("longitudinal", rung(1)*each, "bending", rung(2)*each)));
endfunction

%!function scene = soft_pendulum (pieces)   # rods that bend by more than a quarter of a turn, and a spring at the tip
%!  rod = struct ("length", 1/pieces, "EA", 1e4, "EI", 0.05, "rhoA", 0.2, "damping", 1e-3);
%!  model = struct ("energy", "uniaxial", "rotary_inertia", false);
%!  scene.bodies = repmat ({struct("rod", rod, "model", model)}, 1, pieces);
%!  scene.bodies{end}.tip_mass = 0.05;
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
%!                  struct("kind", "spring", "bodies", pieces, "stations", 1/pieces, ...
%!                         "point", [1 0.5], "stiffness", 2)};
%!  if (pieces == 2)
%!    scene.joints{3} = struct ("kind", "weld", "bodies", [1 2], "stations", [0.5 0]);
%!  endif
%!  [scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.4, 50, 1e-7);
%!endfunction
%!test # welded rods move as one, however far they bend, and keep their energy
%! one = exact_mechanisms (soft_pendulum (1), [5 14]);
%! two = exact_mechanisms (soft_pendulum (2), [4 10]);
%! tip = @(run) [run.history.bodies(end).tip_x; run.history.bodies(end).tip_y];
%! assert (tip (one), tip (two), 2e-6);
%! assert (max (abs (one.history.bodies.tip_psi - one.history.bodies.psi)) > pi/2);
%! for run = {one, two}
%!   balance = run{1}.history.balance;
%!   assert (balance, balance(1)*ones (1, 21), 1e-6*max (run{1}.history.T));
%! endfor
%!function deflection = cantilever (load)   # of its tip at rest, per length, under P l^2/EI
%!  rod = struct ("length", 2, "EA", 2e9, "EI", 2e3, "rhoA", 1, "half_height", 0.01);
%!  scene.bodies = {struct("rod", rod, "model", struct ("energy", "uniaxial"))};
%!  scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)
%!                  struct("kind", "force", "bodies", 1, "stations", 2, "value", [0 -load*2e3/4])};
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!  evalc ("rest = statics (scene, 'output', '', 'exact', true);");
%!  deflection = -rest.shape{end}(end,2)/2;
%!endfunction
%!test # the elastica (Mattiasson, IJNME 17, 1981)
%! assert (arrayfun (@cantilever, [1 5 10]), [0.30172 0.71379 0.81061], 2e-5);
%!test # Kane's spin-up as a mechanism: 0.573835 m behind at 6.762 s, as two independent codes have it
%! scene = as_bodies (setfield (spin_up (), "joints", {}));
%! scene.bodies{1}.model = struct ("energy", "uniaxial", "rotary_inertia", false);
%! [scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (7, 500, 2e-5);
%! body = exact_mechanisms (scene, [3 6]).history.bodies;
%! times = (0:3500)/500;
%! theta = arrayfun (@(t) spin_up ().rotation (t)(1), times);
%! [largest, k] = max (body.tip_x.*sin (theta) - body.tip_y.*cos (theta));
%! assert (largest, 0.573835, 1e-4); assert (times(k), 6.762, 0.01);
%!test # what models with foreshortening drop falls as the square of the length of welded pieces, towards the exact rods
%! rod = struct ("length", 1, "EA", 1e5, "EI", 1, "rhoA", 0.1);
%! scene.bodies = {struct("rod", rod, "tip_mass", 0.05, "model", struct ("energy", "uniaxial"))};
%! scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%! [scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.5, 20, 1e-7);
%! exact = exact_mechanisms (scene, [2 8]).history.bodies;
%! for pieces = [2 4]
%!   divided = check_mechanism (setfield (scene, "pieces", pieces));
%!   each = ones (1, pieces);
%!   mechanism = build_mechanism (divided, mechanism_rungs (divided, 2*each, 0*each));
%!   last = run_model (mechanism_kind (), divided, mechanism).history.bodies(end);
%!   off(pieces) = max (hypot (last.tip_x - exact.tip_x, last.tip_y - exact.tip_y));
%! endfor
%! assert (off(2)/off(4), 4, 1); assert (off(2) > 1e-4);
%!test # an exact rod beside others, which its load leaves rigid, or which have foreshortening
%! stiff = struct ("length", 0.1, "EA", 1e7, "EI", 1e4, "rhoA", 1);
%! soft = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 0.1);
%! model = struct ("energy", "uniaxial");
%! scene.bodies = {struct("rod", stiff, "model", model), struct("rod", soft, "model", model)};
%! scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)
%!                 struct("kind", "weld", "bodies", [2 1], "stations", [0 0.1])
%!                 struct("kind", "force", "bodies", 1, "stations", 0.1, "value", [0 1])};
%! [scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.1, 50, 1e-5);
%! evalc ("exact = driver (scene, 'output', '');");
%! assert (exact.summary.stiffening, {"exact", "exact"}); assert (exact.summary.modes{1}, [0 0]);
%! assert (exact.summary.estimated_error_m <= 1e-5);
%! scene.bodies{2}.model.stiffening = "exact";
%! evalc ("mixed = driver (scene, 'output', '');");
%! assert (mixed.summary.stiffening, {"foreshortening", "exact"});
%! assert (mixed.history.bodies(2).tip_y, exact.history.bodies(2).tip_y, 2e-5);
%!test # small vibrations of a curved rod with rotary inertia and a tip mass are those of the models with linear strains
%! rod = struct ("length", 1, "EA", 1e6, "EI", 10, "rhoA", 0.2, "rhoI", 2e-4, "curvature", 2);
%! model = struct ("energy", "uniaxial", "modes", "auto");
%! scene.bodies = {struct("rod", rod, "tip_mass", 0.1, "model", model)};
%! scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%! [scene.gravity, scene.duration] = deal (0, 1);
%! for exact = [true false]
%!   evalc ("table = natural_modes (scene, 'output', tempdir (), 'pictures', false, 'exact', exact);");
%!   f(1+exact,:) = [table(1:4).f];
%! endfor
%! assert (f(2,:), f(1,:), -1e-5);
