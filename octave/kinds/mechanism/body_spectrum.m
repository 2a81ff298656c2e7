## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} body_spectrum (@var{scene}, @var{run})
## The spectra of the tip (see @code{spectrum_of_tip}) of that body of a mechanism's @var{run} whose coordinates are
## the largest, from the states between its frames (see @code{run_model}), without predicted frequencies: they are of
## the mechanism.  Modes of the rod in its frame are left out where they are too fast.  Empty without such states,
## where all bodies are rigid, or all modes too fast.
## @end deftypefn

function spectrum = body_spectrum (scene, run)
  spectrum = [];
  largest = arrayfun (@(body) max ([0; abs(body.V(:))]), run.history.bodies);
  [deformed, k] = max (largest);
  if (! isfield (run, "between") || deformed == 0)
    return;
  endif
  model = run.model.models{k};
  q = run.between.states(index_of (run.model, k)(1:end-3),:);
  mass = model.arrays.mass_matrix;
  [modes, squares] = free_modes (model.arrays.stiffness_matrix, mass);
  spectrum = spectrum_of_tip (model, struct ("q", q, "phi", zeros (1, columns (q))), diff (run.between.t)(1), modes, ...
                              sqrt (max (0, squares)).'/(2*pi), mass);
  if (isempty (spectrum))
    return;
  endif
  spectrum.label = ["spectra of the tip of " scene.bodies(k).name];
  spectrum.predicted = [];
  spectrum.note = strrep (spectrum.note, "predicted ones", "modes of the rod");
endfunction

%!test # a hinged rod that is bent and let go rings at 15.418 sqrt (EI/rhoA)/l^2
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 1), ...
%!                        "initial", struct ("V2", 1e-3), "model", struct ("modes", [0 4]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! [scene.duration, scene.gravity, scene.solver.tolerance] = deal (0.5, 0, 1e-6);
%! result = driver (scene, "output", "");
%! spectrum = body_spectrum (result.scene, result);
%! [largest, k] = max (spectrum.values(2,:));
%! assert (spectrum.frequency(k), 154.18/(2*pi), 2/0.5); assert (spectrum.label, "spectra of the tip of body 1");
%! assert (spectrum.predicted, []); assert (isempty (body_spectrum (result.scene, rmfield (result, "between"))));
%!test # of the body that deforms most, be it little; none of rigid ones
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 1), "model", struct ("modes", [0 0]))};
%! scene.bodies{2} = setfield (setfield (scene.bodies{1}, "model", struct ("modes", [0 1])), "initial", struct ("x", 2));
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
%!                 struct("kind", "revolute", "bodies", 2, "stations", 0, "point", [2 0])};
%! scene.duration = 0.02;
%! result = driver (scene, "output", "");
%! assert (body_spectrum (result.scene, result).label, "spectra of the tip of body 2");
%! scene.bodies{2}.model.modes = [0 0];
%! result = driver (scene, "output", "");
%! assert (body_spectrum (result.scene, result), []);
