## -*- texinfo -*-
## @deftypefn {} {[@var{tables}, @var{units}] =} verb_tables (@var{scene}, @var{parts}, @var{names_alone}, @
##   @var{options})
## What OBSERVE may ask of the studies of a @var{scene} (a struct, not checked) that @var{parts} (cellstr) name, a field
## each of @var{tables}: modes has f (Hz), omega (rad/s), damping, growth (1/s) and change of the slowest twelve (see
## @code{natural_modes}), and statics what @code{rest_figures} says.  @var{units} has the same fields, each " [m]" or
## "".  With @var{names_alone} nothing is computed: the tables have numbers that mean nothing, and twelve modes; truth,
## which takes a run, is among them (see @code{true_figures}).  The @var{options} (a cell array) go to the studies.
## @end deftypefn

function [tables, units] = verb_tables (scene, parts, names_alone = false, options = {})
  tables = units = struct ();
  if (names_alone && any (strcmp (parts, "truth")))
    [tables.truth, units.truth] = deal (true_figures (), struct ());
  endif
  if (! any (ismember ({"modes", "statics"}, parts)))
    return;
  endif
  scene = without_solver (scene);
  if (names_alone)
    [kind, scene] = kind_at_rest (scene);
  endif
  if (any (strcmp (parts, "modes")))
    units.modes = struct ("f", " [Hz]", "omega", " [rad/s]", "damping", "", "growth", " [1/s]", "change", "");
    tables.modes = structfun (@(unit) zeros (1, 12), units.modes, "uniformoutput", false);
    if (! names_alone)
      rows = natural_modes (scene, "output", "", options{:});
      for name = fieldnames (units.modes).'
        tables.modes.(name{1}) = [rows.(name{1})];
      endfor
    endif
  endif
  if (any (strcmp (parts, "statics")))
    if (names_alone)
      found = unknown_rest (kind, scene);
    else
      found = statics (scene, "output", "", options{:});
    endif
    [tables.statics, units.statics] = rest_figures (found);
  endif
endfunction

function [kind, scene] = kind_at_rest (scene)
  scene = scene_at_rest (scene);
  kind = kind_of (scene);
  scene = kind.check (scene);
  if (isempty (kind.at_rest))
    scene_error ("the kind \"%s\" says nothing of its equilibrium", kind.name);
  endif
endfunction

## the start as if it were one
function found = unknown_rest (kind, scene)
  balance = kind.at_rest (scene, kind.sized (scene, 4));
  found = struct ("stable", 0, "slowest", 0, "vibrations", struct ("rate", 0));
  found.shape = balance.shape (balance.start);
  found.supports = balance.supports (0, balance.start, zeros (field_or (balance, "multipliers", 0), 1));
endfunction

%!test # of every kind the names are those that the studies have
%! for scene = {swing(), double_pendulum(), bowl()}
%!   evalc ("[tables, units] = verb_tables (scene{1}, {'statics', 'modes'});");
%!   [names, same] = verb_tables (scene{1}, {"statics", "modes"}, true);
%!   assert (fieldnames (names.statics), fieldnames (tables.statics)); assert (same, units);
%!   assert (structfun (@numel, names.statics), structfun (@numel, tables.statics));
%!   assert (fieldnames (names.modes), fieldnames (tables.modes));
%! endfor
%!test # of a scene whose solver is none of a mechanism's, too
%! scene = setfield (swing (), "solver", struct ("name", "rk4", "step", 1e-3, "tolerance", 1e-4));
%! assert (numel (verb_tables (scene, {"modes"}, true).modes.f), 12);
%! evalc ("tables = verb_tables (scene, {'modes'});"); assert (tables.modes.f(1) > 0);
%!test # the figures are theirs
%! evalc ("tables = verb_tables (double_pendulum (), {'statics', 'modes'});");
%! evalc ("rows = natural_modes ('double_pendulum', 'output', '');");
%! assert (tables.modes.f, [rows.f]); assert (tables.statics.slowest, rows(1).omega, -1e-6);
%! assert (tables.statics.tip_y(2) < -0.1); assert (numel (tables.statics.reaction_x), 2);
%!test # of geometrically exact rods: a cantilever's tip under P l^2/EI = 1 (Bisshopp and Drucker 1945)
%! scene = struct ("rod", struct ("length", 1, "EA", 1e6, "EI", 2, "rhoA", 1), "gravity", 0, "duration", 1);
%! [scene.rotation, scene.force] = deal (@(t) [0 0 0], @(t) [0 -2]);
%! evalc ("tables = verb_tables (scene, {'statics'}, false, {'exact', true});");
%! assert (tables.statics.tip_y, -0.30172, 1e-5);
%!assert (verb_tables (swing (), {}), struct ())
%!error <the kind "string" says nothing of its equilibrium>
%! with_stand_ins ({"kind = kind_of", "scene", ["kind = struct ('name', 'string', 'at_rest', [], " ...
%!                  "'check', @(scene) scene);"]}, @() verb_tables (struct (), {"modes"}, true));
