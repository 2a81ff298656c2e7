## -*- texinfo -*-
## @deftypefn {} {@var{found} =} gather_rows (@var{plan}, @var{found})
## What the points of a @var{plan} (see @code{plan_sweep}) have left by now, added to what was @var{found} before: a
## struct of observed (cellstr, a row a point, "" where it is not done), done and message (cellstr, "" but of points
## that failed).
## @end deftypefn

function found = gather_rows (plan, found)
  points = fullfile (plan.folder, "points");
  there = readdir (points);
  for k = find (! found.done & ismember (strcat (plan.keys, ".row"), there.'))
    text = fileread (fullfile (points, [plan.keys{k} ".row"]));
    found.observed(k,:) = ostrsplit (text(1:end-1), "\n");
    found.done(k) = true;
    found.message{k} = "";
  endfor
  for k = find (! have_failed (found) & ismember (strcat (plan.keys, ".failed"), there.'))
    found.message{k} = strtrim (fileread (fullfile (points, [plan.keys{k} ".failed"])));
  endfor
endfunction

%!function check (folder)
%!  points = fullfile (folder, "points"); mkdir (points);
%!  plan = struct ("folder", folder, "keys", {{"a", "b", "c"}});
%!  found = struct ("observed", {repmat({""}, 3, 2)}, "done", false (1, 3), "message", {{"", "", ""}});
%!  write_text (fullfile (points, "b.row"), "0.5\na model, rigid\n");
%!  write_text (fullfile (points, "c.failed"), "no\n");
%!  write_text (fullfile (points, "d.row"), "of another sweep\n");
%!  found = gather_rows (plan, found);
%!  assert (found, struct ("observed", {{"", ""; "0.5", "a model, rigid"; "", ""}}, "done", [false true false], ...
%!                         "message", {{"", "", "no"}}));
%!  delete (fullfile (points, "c.failed")); write_text (fullfile (points, "c.row"), "1\n\n");
%!  found = gather_rows (plan, found);
%!  assert (strjoin (found.observed(3,:), ","), "1,"); assert (found.message, {"", "", ""});
%!  assert (found.done, [false true true]);
%!endfunction
%!test in_scratch (@(folder, scratch) check (folder));
