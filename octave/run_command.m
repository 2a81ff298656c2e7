## What `make simulate', `make models' and so on run: the function `command' with the arguments of the environment; an
## error is one line and status 1.
try
  command (environment_options (){:});
catch err
  show_progress ("");
  fprintf (stderr, "%s: %s\n", func2str (command), strtrim (err.message));
  exit (1);
end_try_catch
