## All %!test blocks of the files in the FOLDERS of the environment; every function file has some.
source octave/toolchain_path.m
root = pwd ();
warning ("off", "Octave:shadowed-function");  # tests call scenes by their names, of which `cylinder' is Octave's, too
addpath (fullfile (root, "octave", "scenes"));
cellfun (@(folder) addpath (genpath (fullfile (root, "tests", folder))), ...
         {"octave", "physics", "pairs", "choices", "samples", "map"});
[status, listing] = system ("find $FOLDERS -name '*.m' | sort");
failed = 0;
for file = strsplit (strtrim (listing), "\n")
  text = fileread (file{1});
  if (isempty (regexp (text, "^%!", "once", "lineanchors")) ...
      && isempty (regexp (text, "^function", "once", "lineanchors")))
    continue;  # a script
  endif
  log = tempname ();
  id = fopen (log, "w");
  [passed, total, xfail, bugs, skipped] = test (fullfile (root, file{1}), "quiet", id);
  fclose (id);
  if (passed == total && total + skipped > 0 && xfail + bugs == 0)  # total is without what is skipped
    arrayfun (@(k) printf ("ok %s %d\n", file{1}, k), 1:passed);
    arrayfun (@(k) printf ("skip %s %d\n", file{1}, k), 1:skipped);
  else
    reason = "it has no test";
    if (total > 0)
      reason = strjoin (strsplit (strtrim (fileread (log)), "\n"), " | ");
    endif
    printf ("not ok %s: %d of %d tests passed: %s\n", file{1}, passed, total, reason(1:min (end, 1000)));
    arrayfun (@(k) printf ("ok %s %d\n", file{1}, k), 1:passed);
    failed++;
  endif
  unlink (log);
endfor
lsode (@(y, t) 0, 0, [0 1]);  # it keeps its last function, and all that this can see: scratch folders, too
exit (failed > 0);
