## -*- texinfo -*-
## @deftypefn {} {[@var{refused}, @var{scene}] =} check_points (@var{which}, @var{plan})
## What the checks of the scene @var{which} (see @code{kind_of}) say against the points of a @var{plan} (see
## @code{plan_sweep}), the first and those that are not done: a cellstr, "" where they take one.  Where they take none,
## that is an error.  @var{scene} is the first one that is taken, checked.
## @end deftypefn

function [refused, scene] = check_points (which, plan)
  refused = repmat ({""}, 1, numel (plan.keys));
  scene = [];
  base = which;
  if (! any (strncmp (plan.columns, "argument.", 9)))
    base = scene_at (which, {}, {}, {});  # it is the same for all, and loaded once
  endif
  for k = union (find (! plan.done), 1)
    show_progress (sprintf ("checking point %d of %d", k, numel (plan.keys)));
    try
      checked = scene_at (base, plan.options, plan.columns, plan.values(k,:));
      checked = kind_of (checked).check (checked);
      if (isempty (scene))
        scene = checked;
      endif
    catch err
      refused{k} = strtrim (err.message);
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
%! plan.columns = {"rod.lenght"};
%! fail ("check_points ('swing', plan)", "no point can be run: point 1, rod.lenght=1: rod.lenght is not a field of a");
