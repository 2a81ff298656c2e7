## -*- texinfo -*-
## @deftypefn {} {@var{found} =} frequency_response (@var{scene}, @var{option}, @var{value}, @dots{})
## How a scene of any kind answers small harmonic loads about its equilibrium: amplitudes of outputs a unit of each
## input, of its linear model (see @code{linear_model}, also for the arguments), and of what is prescribed a unit of
## its place or angle; NaN at 0 Hz where nothing brings a motion back. The option "frequencies" has those in Hz
## (rising), by default 400 from a fifth of the slowest vibration to five times the fourth; "outputs" are the tips by
## default.
##
## Leaves response.csv, response.svg and response.png.  @var{found} is a struct of f (1-by-m, Hz), response (complex,
## outputs-by-inputs-by-m), inputs and outputs.
## @end deftypefn

function found = frequency_response (scene = "paper", varargin)
  [f, options] = taken_option (varargin, "frequencies", [], @are_frequencies, ...
                               "rising frequencies in Hz, the last above 0");
  [model, scene, output] = linear_model (scene, options{:});
  if (isempty (model.inputs))
    scene_error (["the scene has neither loads nor prescribed motions: a joint of the kind \"force\" with the" ...
                  " value [0 0], say, is an input"]);
  endif
  if (isempty (f))
    f = spread_frequencies (model.omega);
  endif
  result = struct ("f", f, "response", responses (model, f), "inputs", {model.inputs}, "outputs", {model.outputs});
  if (! any (strcmp (options(1:2:end), "outputs")))
    kept = ! cellfun (@isempty, regexp (result.outputs, '^tip_[xyz]'));
    result.outputs = result.outputs(kept);
    result.response = result.response(kept,:,:);
  endif
  publish_study (output, {"response.csv"}, {"response.svg", "response.png"}, ...
                 @(aside) write_response (result, aside), ...
                 @(scratch) draw_response (result, scene.title, scratch));
  if (nargout > 0)
    found = result;
  endif
endfunction

function f = spread_frequencies (omega)
  own = omega(omega > 0)/(2*pi);
  if (isempty (own))
    own = 1;
  endif
  f = logspace (log10 (own(1)/5), log10 (5*own(min (4, end))), 400);
endfunction

function H = responses (model, f)
  H = zeros (numel (model.outputs), numel (model.inputs), numel (f));
  for k = 1:numel (f)
    H(:,:,k) = model.harmonic (2i*pi*f(k));
  endfor
  if (any (isnan (H(:))))
    say ("warning: at 0 Hz the response is NaN: nothing brings a motion back (make modes)");
  endif
endfunction

function good = are_frequencies (f)
  good = are_rising (f) && f(end) > 0;
endfunction

%!test # a rigid pendulum: phi = F l/(K - s^2 J), and the peak of a damped one
%! scene.rod = struct ("length", 1, "EA", 1, "EI", 1e6, "rhoA", 3, "rhoI", 0);
%! scene.model = struct ("modes", [0 0], "rotary_inertia", false, "axial", "none");
%! scene.initial.phi = -pi/2;
%! scene.joints = {struct("name", "pull", "kind", "force", "stations", 1, "value", [0 0])};
%! scene.duration = 1;
%! [folder, gone] = scratch_folder ();
%! evalc ("found = frequency_response (scene, 'frequencies', [0 0.1 1], 'output', folder);");
%! assert (found.inputs, {"moment [N m]", "pull_x [N]", "pull_y [N]"}(end-1:end));
%! assert (squeeze (found.response(1,1,:)).', 1./(3*9.81/2 - (2*pi*[0 0.1 1]).^2), 1e-8);
%! assert (stat (fullfile (folder, "response.png")).size > 10000);
%! scene.model.modes = [0 1];  # so stiff that it does the same
%! evalc ("stiff = frequency_response (scene, 'frequencies', [0 0.1 1], 'output', folder);");
%! assert (stiff.response(1,1,:), found.response(1,1,:), -1e-5);
%!test # an exact body with a heavy load at its tip bends as F l^3/(3 E I) has it, and its mass is not singular
%! warning ("error", "Octave:nearly-singular-matrix", "local");
%! warning ("error", "Octave:singular-matrix", "local");
%! rod = struct ("length", 0.01, "EA", 8e5, "EI", 0.28, "rhoA", 3);
%! scene.bodies = {struct("name", "beam", "rod", rod, "model", struct ("modes", [4 20], "stiffening", "exact"), ...
%!                       "tip_mass", 1e4)};
%! scene.joints = {struct("name", "wall", "kind", "weld", "bodies", 1, "stations", 0)
%!                 struct("name", "load", "kind", "force", "bodies", 1, "stations", 0.01, "value", [0 0])};
%! scene.gravity = 0;
%! scene.duration = 1;
%! [folder, gone] = scratch_folder ();
%! evalc ("found = frequency_response (scene, 'frequencies', [1e-4 1], 'output', folder);");
%! [across, along] = deal (strcmp (found.outputs, "tip_y_1 [m]"), strcmp (found.inputs, "load_y [N]"));
%! assert (abs (found.response(across,along,1)), 0.01^3/(3*0.28), -1e-5);
%!test # an exact rod answers as one with foreshortening, near its resonance of 11.12 rad/s, too; at rest as it bends
%! scene = struct ("gravity", 0, "duration", 1, "rod", struct ("length", 1.3, "EA", 1e7, "EI", 20, "rhoA", 0.7, ...
%!                 "rhoI", 0, "damping", 2e-3), "rotation", @(t) [0 0 0], "force", @(t) [0 0], "force_station", 0.5);
%! [folder, gone] = scratch_folder ();
%! f = [0 3 11 11.12 30]/(2*pi);
%! ask = @(varargin) frequency_response (scene, "frequencies", f, "output", folder, varargin{:});
%! evalc ("[exact, given] = deal (ask ('exact', true), ask ());");
%! tip = @(found) squeeze (found.response(strncmp (found.outputs, "tip_y", 5),strncmp (found.inputs, "force_y", 7),:));
%! assert (tip (exact), tip (given), -1e-6); assert (tip (exact)(1), 0.5^2*(3*1.3 - 0.5)/(6*20), -1e-6);
%!test # at rest what is prescribed is followed; without a weight nothing brings a rod back to its hinge
%! [folder, gone] = scratch_folder ();
%! evalc ("found = frequency_response ('two_link_arm', 'frequencies', [0 1e-3], 'output', folder);");
%! assert (found.response(:,:,1), found.response(:,:,2), 1e-5);
%! said = evalc ("found = frequency_response ('bowl', 'frequencies', [0 1], 'output', folder);");
%! assert (isnan (found.response(:,:,1))); assert (isfinite (found.response(:,:,2)));
%! assert (! isempty (strfind (said, "warning: at 0 Hz the response is NaN")));
%!error <frequencies is 0: it takes rising frequencies in Hz, the last above 0>
%! frequency_response ("swing", "frequencies", 0)
%!error <frequencies is -1: it takes rising frequencies in Hz> frequency_response ("swing", "frequencies", -1)
%!error <neither loads nor prescribed motions> frequency_response (setfield (chain (1), "duration", 1))
%!test # what is stiff and damped beside it does not hide the slowest: frequencies from a fifth of it
%! scene = setfield (swing (), "joints", {struct("kind", "force", "stations", 0.1, "value", [0 0])});
%! scene.rod.damping = 1e-2;
%! scene.model = struct ("modes", [8 12], "energy", "uniaxial");
%! [folder, gone] = scratch_folder ();
%! evalc ("found = frequency_response (scene, 'output', folder);");
%! evalc ("modes = natural_modes (scene, 'output', folder);");
%! assert (found.f(1), modes(1).f/5, -1e-3);
