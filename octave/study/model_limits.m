## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} model_limits (@var{kind}, @var{scene}, @var{model}, @var{run}, @var{left})
## How near a @var{run} of a checked scene by a @var{model} comes to where the model ends (see @code{kind_of}): rows
## for the table of @code{scene_stability}, of method ("model"), what (with the limit), predicted (NaN) and measured
## (what the run reaches).  Without a run ([]) it is made in a third of the seconds that are @var{left} (); what takes
## longer leaves no rows, which is said.
## @end deftypefn

function rows = model_limits (kind, scene, model, run, left)
  rows = struct ("method", {}, "what", {}, "predicted", {}, "measured", {});
  if (isempty (run))
    try
      run = run_model (kind, scene, model, setfield (scene.solver, "seconds", left ()/3));
    catch err
      rethrow_others (err, "toolchain:integration");
      say ("  the model's limits are not compared with a run: %s", strtrim (err.message));
      return;
    end_try_catch
  endif
  for limit = kind.limits (scene, run)
    rows(end+1) = struct ("method", "model", "what", sprintf ("%s (it holds to %.4g)", limit.what, limit.limit), ...
                          "predicted", NaN, "measured", limit.reached);
  endfor
endfunction

%!test # of a rod that no load bends nothing is near; one that takes too long says so
%! scene = check_scene (setfield (paper (), "moment", 0));
%! scene.duration = 0.1;
%! model = build_model (scene, rung_of_scene (setfield (scene, "model", "modes", [0 2])));
%! rows = model_limits (rod_kind (), scene, model, [], @() Inf);
%! assert (rows(1).what, "slope v2,1 (it holds to 0.2)"); assert (rows(1).measured < 1e-3);
%! said = evalc ("rows = model_limits (rod_kind (), scene, model, [], @() 0);");
%! assert (numel (rows), 0); assert (! isempty (strfind (said, "given up")));
