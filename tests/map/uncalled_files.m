## -*- texinfo -*-
## @deftypefn {} {@var{found} =} uncalled_files (@var{calls}, @var{files}, @var{entries})
## Those of the @var{files} to which no way of @var{calls} (see @code{call_graph}) leads from one of the @var{entries}:
## by default the scenes, which are called by names that users give, and what Makefile and README.md hand to
## @code{octave --eval} or name as an entry.  Tests are no calls: what only they call is not used.
## @end deftypefn

function found = uncalled_files (calls, files, entries = entries_of (files))
  found = setdiff (files, entries);
  do
    before = numel (found);
    found = setdiff (found, {calls(! ismember ({calls.caller}, found)).called});
  until (numel (found) == before)
endfunction

function entries = entries_of (files)
  root = fileparts (fileparts (which ("driver")));
  text = [fileread(fullfile (root, "Makefile")), fileread(fullfile (root, "README.md"))];
  typed = regexp ([regexp(text, '--eval (''[^'']*''|\w+)|entry = \w+\n', "match"){:}], '\w+', "match");
  [folders, names] = cellfun (@fileparts, files, "UniformOutput", false);
  entries = files(strcmp (folders, "octave/scenes") | ismember (names, typed));
endfunction

%!test
%! call = @(from, to) struct ("caller", from, "called", to);
%! calls = [call("driver.m", "a.m"); call("a.m", "b.m"); call("c.m", "d.m"); call("d.m", "c.m"); call("d.m", "a.m")];
%! assert (uncalled_files (calls, {"a.m", "b.m", "c.m", "d.m", "driver.m"}, {"driver.m"}), {"c.m", "d.m"});
%!test # the project's
%! [calls, files] = call_graph ();
%! assert (strjoin (uncalled_files (calls, files), "\n"), "");
