## -*- texinfo -*-
## @deftypefn {} {@var{text} =} feature_table ()
## What a scene of each kind can have, as README.md's table in Markdown.
##
## A cell says yes where the kind takes the small scene of tests/pairs/ with that feature, up to its system of
## equations; where an error refuses it by its name, the reason why not (see @code{feature_rows}), or "not yet".  A
## reason beside what is taken is an error.  Integrators follow from the forms of the systems, the last rows from what
## the kinds have (see @code{kind_of}) and what a short run of theirs shows.
## @end deftypefn

function text = feature_table ()
  scenes = base_scenes ();
  fields_of = [2 2 3 4];
  text = "| | one straight rod | one curved rod | mechanism | rod on a surface |\n|---|---|---|---|---|\n";
  for feature = feature_rows ().'
    cells = cell (1, 4);
    for k = 1:4
      cells{k} = cell_of (scenes{k}, feature{fields_of(k)}, feature{5}{k});
    endfor
    text = [text, table_row(feature{1}, cells)];
  endfor
  text = [text, rows_of_forms(scenes), rows_of_runs(scenes)];
endfunction

function scenes = base_scenes ()
  rod = rod_choices ();
  scenes = {rod, setfield(rod, "rod", "curvature", [2 -1]), mechanism_choices(), surface_choices()};
endfunction

function text = cell_of (scene, change, reason)
  text = reason;
  if (isempty (change))
    return;
  endif
  refusal = refusal_of (changed (scene, change));
  if (! isempty (refusal))
    assert (! isempty (strfind (refusal, named (change))), "%s", refusal);
    if (isempty (reason))
      text = "not yet";
    endif
  elseif (! isempty (reason))
    error ("feature_table: %s is taken, and has a reason why not: %s", named (change), reason);
  else
    text = "yes";
    curved = @(scene) changed (scene, {"rod.curvature", -1});
    if (isfield (scene, "bodies") && ! isempty (refusal_of (curved (changed (scene, change)))))
      text = "yes, on straight rods";
    endif
  endif
endfunction

## what the scene's check or its system says against it; empty where it is taken
function said = refusal_of (scene)
  said = "";
  try
    built (scene);
  catch err
    rethrow_others (err, "toolchain:scene");
    said = err.message;
  end_try_catch
endfunction

## with the first rung of the ladder where the number of modes is to be chosen
function [kind, scene, model, system] = built (scene)
  kind = kind_of (scene);
  scene = kind.check (scene);
  rung = kind.stated (scene);
  if (isempty (rung))
    ladder = kind.ladder (scene);
    [rung, ~] = ladder.first ();
  endif
  model = kind.build (scene, rung);
  system = kind.system (scene, model);
endfunction

function name = named (change)
  name = "joints";
  if (iscell (change))
    name = change{1};
  endif
endfunction

function scene = changed (scene, change)
  if (isstruct (change))
    scene.joints{end+1} = change;
  elseif (isfield (scene, "bodies"))
    scene.bodies{2} = changed (scene.bodies{2}, change);
  else
    for pair = reshape (change, 2, [])
      scene = setfield (scene, strsplit (pair{1}, "."){:}, pair{2});
    endfor
  endif
endfunction

## integrators by the form of the equations that they take; a name that has stood before has its row
function text = rows_of_forms (scenes)
  [~, ~, ~, in_hub] = built (changed (scenes{1}, {"rotation", @(t) [0 0 0]}));
  text = "";
  stood = {};
  for form = unique ({integrator_table().form}, "stable")
    cells = why_not (form{1});
    names = {integrator_table(form).name};
    if (! strcmp (form{1}, "constrained"))
      names = setdiff (names, stood, "stable");
    endif
    stood = [stood, names];
    for k = 1:4
      [~, ~, ~, system] = built (scenes{k});
      if (all (ismember (names, {integrator_table(system.forms).name})))
        cells{k} = "yes";
      endif
    endfor
    if (strcmp (cells{1}, "yes") && ! ismember (form{1}, in_hub.forms))
      cells{1} = "yes, not in a hub";
    endif
    text = [text, table_row(["`" strjoin(names, "`, `") "`"], cells)];
  endfor
endfunction

function cells = why_not (form)
  cells = {"not yet", "not yet", "joints are constraints", "not yet"};
  if (strcmp (form, "constrained"))
    cells = repmat ({"it has no joints"}, 1, 4);
  elseif (strcmp (form, "momenta"))
    cells{4} = "its mass changes with its place; `gauss` is symplectic there";
  elseif (strcmp (form, "residual"))
    cells(1:2) = {"what is stiff is linear: `waveform` has it exactly"};
  elseif (strcmp (form, "oscillators"))
    cells{4} = "its frequencies change with its place";
  endif
endfunction

## what runs and studies have to show, of a run of 10 ms
function text = rows_of_runs (scenes)
  for k = 1:4
    [kind, scene, model, system] = built (setfield (scenes{k}, "duration", 0.01));
    run = run_model (kind, scene, model, scene.solver, [], true);
    rungs = kind.rungs (scene, kind.stated (scene), kind.far_richer (scene, model));
    columns_of = regexprep (kind.columns (scene, run), '(_\d+)? \[.*', '');
    has(:,k) = [! isempty(kind.sized (scene, 8)) && numel(kind.reference) == 2
                numel(rungs) > 1
                any(ismember (system.forms, {"rate", "constrained"}))
                rests(scenes{k})
                rests(scenes{k})
                rests(scenes{k})
                ! isempty(kind.turning)
                seeks_equilibrium(scenes{k})
                ! isempty(kind.spectrum (scene, run))
                iscellstr(kind.warnings (scene, run))
                ! isempty(kind.dropped (scene, run, run))
                all(ismember ({"mid_x", "mid_y"}, columns_of))
                all(ismember ({"psi", "tip_psi"}, columns_of))
                all(ismember ({"reaction_x", "reaction_y"}, columns_of))];
  endfor
  names = {"`make chart`", "`make models`", "`make stability`", "`make statics`", "`make modes`", ...
           "`make response`", "`make campbell`", "a start in equilibrium", "spectra of the tip", ...
           "warnings where the model does not hold", "what all its models drop, in the estimated error", ...
           "place of mid-span over time", "angles of the tangent at both ends over time", ...
           "reactions of the supports over time"};
  cells = repmat ({"not yet"}, size (has));
  cells(has) = {"yes"};
  cells{11,2} = [cells{11,2} "; a bound where it is thick"];
  cells{11,4} = "it drops nothing";
  text = "";
  for j = 1:numel (names)
    text = [text, table_row(names{j}, cells(j,:))];
  endfor
endfunction

## one rod is a body there
function yes = rests (given)
  kind = kind_of (scene_at_rest (given));
  scene = kind.check (scene_at_rest (given));
  balance = kind.at_rest (scene, kind.sized (scene, 4));
  yes = isfinite (balance.residual (0, balance.start, 0*balance.start, zeros (balance.multipliers, 1))(1));
endfunction

## which some of the scenes have not
function yes = seeks_equilibrium (given)
  refusal = refusal_of (setfield (given, "initial", "equilibrium"));
  yes = isempty (refusal) || strncmp (refusal, "no equilibrium was found", 24);
endfunction

function text = table_row (name, cells)
  text = sprintf ("| %s |%s\n", name, sprintf (" %s |", cells{:}));
endfunction

%!test # README.md has it as the code has it
%! text = feature_table ();
%! readme = fileread (fullfile (fileparts (fileparts (which ("driver"))), "README.md"));
%! how = "octave --eval 'source octave/toolchain_path.m; addpath tests/octave tests/pairs; puts (feature_table ());'";
%! other = strjoin (setdiff (strsplit (text, "\n"), strsplit (readme, "\n")), "\n");
%! assert (! isempty (strfind (readme, ["\n\n" text "\n"])), ...
%!         "README.md has not these rows:\n%s\nprint all by %s", other, how);
