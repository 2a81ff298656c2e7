## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} rod_ladder (@var{scene})
## The ladder of models (see @code{choose}) of a checked scene of one straight rod: from the rigid rod over bending
## modes to longitudinal modes that follow their loads without inertia, and to those that vibrate, each with or without
## foreshortening (see @code{rung_of_scene}).  @code{predict_rung} guesses from the loads; of a rod with joints, which
## the rigid rod's motion does not tell, the first rung that is tried has two bending modes.
## @end deftypefn

function ladder = rod_ladder (scene)
  ladder.share = 0.95;
  ladder.parts = {"axial", "bending", "stiffening"};
  ladder.first = @() predict_rung (scene);
  if (! isempty (scene.joints))
    ladder.first = @() deal (two_modes (scene.model), "");
  endif
  ladder.richer = @(rung) richer_rung (rung, scene);
  ladder.smaller = @(rung, part) smaller_rung (rung, part, scene);
  ladder.left_out = @left_out_of;
  ladder.poorer = @(rung, reference) clearly_fewer ([rung.bending, rung.longitudinal], ...
                                                    [reference.bending, reference.longitudinal]);
  ladder.label = @rung_label;
  ladder.labels = "bending modes; q: longitudinal ones follow quasi-statically; +n: n longitudinal ones";
  ladder.curve = @curve_of;
  ladder.solver = setfield (setfield (scene.solver, "name", "auto"), "tolerance", scene.solver.tolerance/5);
  ladder.name = @rung_name;
endfunction

function rung = two_modes (choice)
  rung = struct ("sines", [], "bending", 2, "longitudinal", strcmp (choice.axial, "dynamic"), ...
                 "axial", strrep (choice.axial, "auto", "none"), ...
                 "stiffening", strrep (choice.stiffening, "auto", "none"));
endfunction

function name = curve_of (rung)
  name = "no foreshortening";
  if (strcmp (rung.stiffening, "foreshortening"))
    name = "with foreshortening";
  endif
endfunction

## of the reference's modes, which are those of the rung and more; another treatment of them tells nothing before it is
## run
function metres = left_out_of (reference, rung, part)
  metres = NaN;
  all_of = reference.rung;
  n1 = columns (reference.model.basis) - all_of.bending;
  [along, across] = functions_at (reference.model.base, linspace (0, reference.model.length, 21).');
  if (strcmp (part, "bending"))
    metres = largest (across, reference, n1 + (rung.bending+1:all_of.bending));
  elseif (strcmp (part, "axial") && strcmp (rung.axial, "dynamic") && strcmp (all_of.axial, "dynamic"))
    metres = largest (along, reference, rung.longitudinal+1:n1);
  endif
endfunction

function metres = largest (functions, reference, modes)
  points = functions*reference.model.basis(:,modes)*reference.history.q(modes,:);
  metres = max ([0; abs(points(:))]);
endfunction

%!test # the paper's scene needs the foreshortening and bending modes, no longitudinal ones; one mode less is too few
%! scene = check_scene (paper ());
%! scene.duration = 0.6; scene.solver.tolerance = 2e-5;
%! choice = choose (ladder_of (rod_kind (), scene), scene.solver.tolerance);
%! assert (choice.rung.axial, "none");
%! assert (choice.rung.bending >= 2 && choice.rung.bending <= 5);
%! assert (choice.error_m < 2e-5); assert (choice.warnings, {});
%! smaller = setfield (choice.rung, "bending", choice.rung.bending - 1);
%! assert (distance (trial_run (scene, smaller), choice.reference) > 1.9e-5);
%! names = {choice.tried.name};
%! assert (numel (unique (names)), numel (names));
%!test # what a rung with fewer modes leaves out of a motion
%! scene = check_scene (setfield (setfield (paper (), "duration", 0.3), "solver", "tolerance", 1e-4));
%! rung = struct ("sines", [], "bending", 3, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! ladder = ladder_of (rod_kind (), scene);
%! reference = try_rung (ladder, rung);
%! [~, across] = functions_at (reference.model.base, linspace (0, 1, 21).');
%! third = across*reference.model.basis(:,3)*reference.history.q(3,:);
%! less = setfield (rung, "bending", 2);
%! assert (ladder.left_out (reference, less, "bending"), max (abs (third(:))));
%! assert (ladder.left_out (reference, rung, "bending"), 0);
%! assert (ladder.left_out (reference, less, "stiffening"), NaN);
%!test # a rod with springs: few modes of the rod and its springs, whose error is what a far richer model says
%! scene.rod = struct ("length", 1, "EA", 1e5, "EI", 1, "rhoA", 1);
%! scene.joints = {struct("kind", "torsion_spring", "stations", 0, "stiffness", 0.5), ...
%!                 struct("kind", "spring", "stations", 0.4, "point", [0.2 0.5], "stiffness", 30, "rest", 0.5385164807)};
%! [scene.gravity, scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0.1, 2, 20, 1e-5);
%! scene = check_scene (setfield (scene, "model", "energy", "uniaxial"));
%! choice = choose (ladder_of (rod_kind (), scene), scene.solver.tolerance);
%! assert (choice.rung.bending <= 4); assert (choice.rung.axial, "none");
%! rich = trial_run (scene, struct ("sines", [], "bending", 15, "longitudinal", 5, "axial", "dynamic", ...
%!                                  "stiffening", "foreshortening"));
%! true_error = distance (choice.trial, rich);
%! assert (true_error <= 1e-5); assert (choice.error_m/true_error, 1, 0.3);
