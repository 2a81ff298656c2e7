## -*- texinfo -*-
## @deftypefn {} {[@var{refused}, @var{scene}, @var{given}] =} check_points (@var{which}, @var{plan})
## What the checks of the scene @var{which} (see @code{kind_of}) say against the points of a @var{plan} (see
## @code{plan_sweep}), the first and those that are not done: a cellstr, "" where they take one.  Where they take none,
## that is an error.  @var{scene} is the first one that is taken, checked, and @var{given} the same before that.
## @end deftypefn

function [refused, scene, given] = check_points (which, plan)
  refused = repmat ({""}, 1, numel (plan.keys));
  scene = given = [];
  base = which;
  if (! any (strncmp (plan.columns, "argument.", 9)))
    base = scene_at (which, {}, {}, {});  # it is the same for all, and loaded once
  endif
  for k = union (find (! plan.done), 1)
    show_progress (sprintf ("checking point %d of %d", k, numel (plan.keys)));
    try
      unchecked = scene_at (base, plan.options, plan.columns, plan.values(k,:));
      checked = kind_of (unchecked).check (unchecked);
      if (isempty (scene))
        [scene, given] = deal (checked, unchecked);
      endif
    catch err
      refused{k} = point_message (err);
    end_try_catch
  endfor
  show_progress ("");
  if (isempty (scene))
    scene_error ("no point can be run: point 1, %s: %s", point_words (plan.columns, plan.values(1,:)), refused{1});
  endif
endfunction

%!test
%! plan = struct ("keys", {{"a", "b", "c", "d"}}, "columns", {{"rod.length"}}, "values", {{1; -1; 2; -2}}, ...
%!                "options", {{"tolerance", 1e-3}}, "done", [false false false true]);
%! [refused, scene] = check_points ("swing", plan);
%! assert (refused, {"", "rod.length is -1: it takes positive number in m", "", ""});
%! assert ([scene.rod.length, scene.solver.tolerance], [1 1e-3]);
%! plan.columns = {"argument.1"};
%! [refused, scene] = check_points ("chain", setfield (plan, "values", {2; "x"; 3; 4}));
%! assert (refused, {"", "argument.1 is \"x\": it takes a number", "", ""}); assert (numel (scene.bodies), 2);
%!function file = write_indexed (folder)
%!  file = fullfile (folder, "indexed.m");
%!  write_text (file, ["function scene = indexed (k)\n  if (k > 3)\n    error ('no rod %d', k);\n  endif\n" ...
%!                     "  scene = swing ();\n  scene.duration = [1 2](k);\nendfunction\n"]);
%!endfunction
%!test # what a scene's function says of an argument, and an error of its own
%! plan = struct ("keys", {{"a", "b", "c"}}, "columns", {{"argument.1"}}, "values", {{1; 3; 4}}, ...
%!                "options", {{}}, "done", [false false false]);
%! refused = in_scratch (@(folder, scratch) check_points (write_indexed (folder), plan));
%! assert (refused([1 3]), {"", "no rod 4"});
%! assert (strncmp (refused{2}, "indexed.m, line 6: index (3): out of bound", 42));
%!test # none that can be run
%! plan = struct ("keys", {{"a"}}, "columns", {{"rod.lenght"}}, "values", {{1}}, "options", {{}}, "done", false);
%! fail ("check_points ('swing', plan)", "no point can be run: point 1, rod.lenght=1: rod.lenght is not a field of a");
