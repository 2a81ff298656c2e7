## What `make simulate', `make models' and so on run: the function `command' with the arguments of the environment, and
## with those `settings' that it has of its own; an error is one line and status 1.  One that is ended leaves no file
## octave-workspace.
sigterm_dumps_octave_core (false);
if (! exist ("settings", "var"))
  settings = cell (0, 3);
endif
try
  if (! isempty (getenv ("SCENE")))
    reach_beside (getenv ("SCENE"));
  endif
  command (environment_options (settings){:});
catch err
  show_progress ("");
  fprintf (stderr, "%s: %s\n", func2str (command), strtrim (err.message));
  exit (1);
end_try_catch
