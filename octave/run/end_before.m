## -*- texinfo -*-
## @deftypefn {} {@var{before} =} end_before (@var{kind}, @var{scene})
## The end of the run from which that of a checked scene of a @var{kind} (see @code{kind_of}) goes on, where
## initial.from has its folder (see @code{write_end}), or empty: a struct of folder and model (texts), rung, state (a
## column) and points (points-by-2, or by 3 where they leave the plane, m).  An end of another kind, or of another
## number of bodies, is an error.
## @end deftypefn

function before = end_before (kind, scene)
  before = [];
  if (! (isfield (scene, "initial") && isfield (scene.initial, "from"))
      || any (strcmp (scene.initial.from, {"", "equilibrium"})))
    return;
  endif
  folder = scene.initial.from;
  lines = strsplit (strtrim (fileread (fullfile (folder, "end.csv"))), "\n");
  try
    had = jsondecode (lines{2});
    before = struct ("folder", folder, "model", lines{1}, "rung", {with_rows(had.rung)});
  catch
    scene_error ("initial.from is \"%s\": its end.csv lacks the model of that run, which is to be run again", folder);
  end_try_catch
  refuse_others (kind, scene, strsplit (lines{1}, ": "){1}, had.bodies);
  numbers = lines(3:end);
  is_point = ! cellfun (@isempty, strfind (numbers, ","));
  before.state = str2double (numbers(! is_point)(:));
  before.points = cell2mat (cellfun (@(line) sscanf (line, "%f,").', numbers(is_point)(:), "UniformOutput", false));
endfunction

## what JSON has made columns of
function rung = with_rows (rung)
  if (isnumeric (rung) && isvector (rung))
    rung = rung(:).';
  elseif (isstruct (rung))
    rung = structfun (@with_rows, rung, "UniformOutput", false);
  endif
endfunction

function refuse_others (kind, scene, name, bodies)
  remedy = "take the end of a run of the same scene";
  if (strncmp (name, "exact", 5))
    remedy = "EXACT=no runs it so that another can go on";
  endif
  if (! strcmp (name, kind.name))
    scene_error ("initial.from is \"%s\": that run was of the kind \"%s\", this one is of the kind \"%s\": %s", ...
                 scene.initial.from, name, kind.name, remedy);
  endif
  count = numel (kind.models (scene));
  if (bodies != count)
    scene_error ("initial.from is \"%s\": that run had %s, this one has %d: %s", scene.initial.from, ...
                 how_many (bodies, "body", "bodies"), count, remedy);
  endif
endfunction

%!function before = end_of (name, rung, count = 1, text = "")   # before a run of a rod of so many bodies
%!  [folder, gone] = scratch_folder ();
%!  kind = struct ("name", name, "describe", @(scene, run) struct ("model", "modes"), "models", @(scene) 1);
%!  run = struct ("rung", {rung}, "model", 1, "end_state", [0.1; 1e-20], "history", struct ("t", 1));
%!  [run.x, run.y] = deal ([0 1; 2 3], [0 4; 0 5]);
%!  write_end (kind, struct (), run, folder);
%!  if (! isempty (text))
%!    write_text (fullfile (folder, "end.csv"), text);
%!  endif
%!  kind = struct ("name", "rod", "models", @(scene) ones (1, count));
%!  before = end_before (kind, struct ("initial", struct ("from", folder)));
%!endfunction
%!test # rungs of every kind come back as they were, with state and points to the last bit
%! rod = struct ("sines", [], "bending", 6, "longitudinal", 0, "axial", "none", "stiffening", "foreshortening");
%! for rung = {rod, curved_rung([1 2]), struct("bending", [3 0], "longitudinal", [0 1]), [8 8], 3}
%!   before = end_of ("rod", rung{1});
%!   assert (before.rung, rung{1});
%!   assert (before.state, [0.1; 1e-20]); assert (before.points, [1 4; 3 5]);
%!   assert (before.model, "rod: modes, at t = 1 s");
%! endfor
%!assert (end_before ([], struct ("initial", struct ("from", "equilibrium"))), [])
%!error <that run was of the kind "exact", this one is of the kind "rod": EXACT=no runs it so> end_of ("exact", 3)
%!error <of the kind "surface", this one is of the kind "rod": take the end of a run of the same> end_of ("surface", 3)
%!error <that run had 1 body, this one has 2> end_of ("rod", 3, 2)
%!error <its end.csv lacks the model of that run, which is to be run again>
%! end_of ("rod", 3, 1, "rod: modes\n0.1\n1\n")
