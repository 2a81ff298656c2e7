## -*- texinfo -*-
## @deftypefn {} {[@var{outcome}, @var{message}] =} try_scene (@var{scene})
## Run a @var{scene} without files.  @var{outcome} is "ran", "refused" (the scene asks for what cannot be), "stopped"
## (its integration), "wrong" (what it left is no number, its energy balance is off, or the solver "auto" moves its
## tips elsewhere) or "internal" (an error or a warning of Octave's own); @var{message} says more, in a line.
## @end deftypefn

function [outcome, message] = try_scene (scene)
  lastwarn ("");
  try
    evalc ("result = driver (scene, 'output', '');");
    [outcome, message] = judge (scene, result, last_warning ());
  catch err
    message = strtrim (err.message);
    switch (regexprep (err.identifier, '^(toolchain:\w+):.*', '$1'))
      case "toolchain:scene"
        outcome = "refused";
      case "toolchain:integration"
        outcome = "stopped";
      otherwise
        outcome = "internal";
        if (! isempty (err.stack))
          message = sprintf ("%s (%s, line %d)", message, err.stack(1).name, err.stack(1).line);
        endif
    endswitch
    if (any (message == "\n"))
      [outcome, message] = deal ("internal", ["more than a line: " strrep(message, "\n", " | ")]);
    endif
  end_try_catch
endfunction

function [outcome, message] = judge (scene, result, warned)
  balance = result.summary.largest_energy_error;
  outcome = "wrong";
  if (! isempty (warned))
    [outcome, message] = deal ("internal", ["warning: " warned]);
  elseif (! all_numbers (result.history))
    message = "history is no number";
  elseif (! (balance < 0.05) && ! result.count.still)
    message = sprintf ("energy balance is off by %.1g", balance);
  elseif (! (elsewhere (scene, result) < 1))
    message = "the tips are elsewhere with the solver auto";
  else
    [outcome, message] = deal ("ran", sprintf ("energy balance %.1g", balance));
  endif
endfunction

## how far the tips are from those of the solver "auto", in what they may be off by: methods of stated steps by more
function off = elsewhere (scene, result)
  off = 0;
  chosen = ! isempty (result.summary.tried);  # it may choose another model, within the tolerance
  if (isfield (scene.solver, "name") && ! strcmp (scene.solver.name, "auto") && ! chosen)
    model = scene;
    model.solver.name = "auto";
    evalc ("other = driver (model, 'output', '');");
    equal_steps = isfield (result.scene.solver, "step") && ! isempty (result.scene.solver.step) ...
                  && ! any (strcmp (scene.solver.name, adaptive_methods ()));
    may = result.scene.solver.tolerance*(5 + 95*equal_steps);
    off = max (max (abs (tips_of (result.history) - tips_of (other.history))(:)))/may;
  endif
endfunction

function names = adaptive_methods ()
  table = integrator_table ();
  names = setdiff ({table([table.adaptive]).name}, {table(! [table.adaptive]).name});
endfunction

function tips = tips_of (history)
  if (isfield (history, "bodies"))
    tips = [vertcat(history.bodies.tip_x); vertcat(history.bodies.tip_y)];
  elseif (isfield (history, "tip"))
    tips = history.tip;
  else
    tips = [history.tip_x; history.tip_y];
  endif
endfunction

function good = all_numbers (value)
  good = true;
  if (isstruct (value))
    good = all (cellfun (@all_numbers, struct2cell (value)(:)));
  elseif (isnumeric (value))
    good = all (isfinite (value(:)));
  endif
endfunction

%!function scene = plain ()
%!  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.015), "duration", 0.1, ...
%!                  "model", struct ("modes", [0 0]), "solver", struct ("name", "ode45"));
%!endfunction
%!test # a good scene, a refused one, and one whose load ends in an error of Octave's own
%! assert (try_scene (plain ()), "ran");
%! [outcome, message] = try_scene (setfield (plain (), "rod", "length", -1));
%! assert ({outcome, message}, {"refused", "rod.length is -1: it takes positive number in m"});
%! assert (try_scene (setfield (plain (), "solver", 3)), "refused");
%!test # steps that are too long are seen: their tip is elsewhere
%! scene = setfield (plain (), "solver", struct ("name", "trigonometric", "step", 0.05, "tolerance", 1e-9));
%! scene.frames_per_second = 20;
%! [outcome, message] = try_scene (scene);
%! assert ({outcome, message}, {"wrong", "the tips are elsewhere with the solver auto"});
