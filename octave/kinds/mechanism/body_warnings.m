## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} body_warnings (@var{scene}, @var{run})
## Where the bodies of a mechanism's @var{run} leave what their models hold for, a cellstr that names them: slopes,
## strains, and rates of rotation without foreshortening (see @code{spin_warning}).
## @end deftypefn

function warnings = body_warnings (scene, run)
  warnings = {};
  instead = mechanism_kind ().instead (scene);
  for k = 1:numel (run.history.bodies)
    body = scene.bodies(k);
    spin = spin_warning (body, run.model.models{k}, max (abs (run.history.bodies(k).phi_dot)));
    warnings = [warnings, limit_warnings(limits_of_body (scene, run, k), [body.name ": "], instead), ...
                strcat(body.name, {": "}, spin)];
  endfor
endfunction

%!test # a rod that bends too far is named
%! [system, start, scene] = sample_mechanism ([0 1]);
%! start.q(index_of (system.mechanism, 2)(1)) = 0.1;
%! run.model = system.mechanism;
%! run.history = measure_mechanism (system, 0, start);
%! assert (! isempty (regexp (body_warnings (scene, run){1}, "^body 2: the slope v2,1 reaches 0.63, .* up to 0.3")));
%!test # a rod that turns faster than it keeps its stiffness, and is stretched by it
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e3, "EI", 1, "rhoA", 1), "initial", struct ("phi_dot", 8), ...
%!                        "model", struct ("modes", [1 1], "energy", "uniaxial"))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! [scene.duration, scene.gravity, scene.solver.tolerance] = deal (0.05, 0, 1e-4);
%! warnings = driver (scene, "output", "").summary.warnings;
%! said = @(text) any (! cellfun (@isempty, regexp (warnings, text)));
%! assert (said ("^body 1: phi_dot reaches 8 rad/s, .* first frequency is 9.87 rad/s: without foreshortening"));
%! assert (said ("^body 1: the strain v1,1 reaches 0.0[2-9]"));
