## -*- texinfo -*-
## @deftypefn {} {[@var{units}, @var{count}] =} observable_units (@var{scene}, @var{items}, @var{given})
## The units of what the @var{items} of OBSERVE (see @code{read_observe}) ask of a checked @var{scene}, " [m]" or "" (a
## cellstr): those of the columns that two frames of it have, of which there are so many (@var{count}) with a
## small model.  A column that its runs do not have, whatever their model's size, is an error, and so is what
## their summary does not have, or the studies (see @code{verb_tables}) of the scene as it was @var{given}.
## @end deftypefn

function [units, count] = observable_units (scene, items, given)
  units = repmat ({""}, 1, numel (items));
  [names, summary] = short_run (scene);
  count = numel (names);
  [bare, unit] = strtok (names, " ");
  [tables, of_tables] = verb_tables (given, {items.part}, true);
  [tables.summary, of_tables.summary] = deal (summary, struct ());
  is_column = ! ismember ({items.part}, fieldnames (tables));
  for k = find (! is_column)
    observed_value (items(k), {}, [], tables);
    units{k} = field_or (of_tables.(items(k).part), items(k).name, "");
  endfor
  for k = find (is_column)
    row = find (strcmp (any_number (items(k).name), any_number (bare)), 1);
    if (isempty (row))
      scene_error ("OBSERVE: history.csv has no column %s: those are %s", items(k).name, strjoin (bare, ", "));
    endif
    units{k} = unit{row};
  endfor
endfunction

function [names, summary] = short_run (scene)
  kind = kind_of (scene);
  scene.duration = min (scene.duration, 1/scene.frames_per_second);
  [scene.solver.name, scene.solver.step] = deal ("auto", []);  # what the scene's own makes of it is another matter
  if (has_field (scene, {"initial", "from"}))
    scene.initial.from = "";  # nor do other runs have these modes
  endif
  model = kind.sized (scene, 4);
  run = run_model (kind, scene, model);
  names = kind.columns (scene, run);
  summary = summarise (kind, "", scene, run, given_choice ([], ""));
endfunction

## V2_1 and V2_7 are columns of the same sort
function names = any_number (names)
  names = regexprep (names, '\d+', "1");
endfunction

%!test
%! units = @(scene, text) observable_units (kind_of (scene).check (scene), read_observe (text), scene);
%! assert (units (swing (), "max|tip_y|, model, last V2_30, last phi_dot"), {" [m]", "", " [m]", " [rad/s]"});
%! assert (units (chain (2), "last tip_x_2, last lambda_1_1"), {" [m]", " [N]"});
%! assert (units (bowl (), "last tip_z, last T"), {" [m]", " [J]"});
%! assert (units (swing (), "model, estimated_error_m, modes(2), seconds.choice, title"), repmat ({""}, 1, 5));
%! [folder, gone] = scratch_folder ();
%! write_text (fullfile (folder, "end.csv"), "of another run");
%! assert (units (setfield (swing (), "initial", folder), "last phi"), {" [rad]"});
%! assert (units (swing (), "modes.f(12), statics.reaction_x, modes.damping(1)"), {" [Hz]", " [N]", ""});
%! assert (units (swing (), "truth.error_m, truth.smaller_m"), {"", ""});
%! fail ("units (swing (), 'modes.g(1)')", "OBSERVE: modes has no g: it has f, omega, damping, growth, change");
%! fail ("units (swing (), 'modes.f(13)')", "OBSERVE: modes.f\\(13\\) of modes is no number");
%! fail ("units (swing (), 'statics.tip_z')", "OBSERVE: statics has no tip_z: it has stable, slowest, growth, tip_x");
%! fail ("units (swing (), 'modus')", "OBSERVE: summary.json has no modus");
%! fail ("units (swing (), 'modes')", "OBSERVE: modes of summary.json is no number and no text, but a 1-by-2 double");
%! fail ("units (swing (), 'max tip_z')", "OBSERVE: history.csv has no column tip_z: those are t, phi, .*");
