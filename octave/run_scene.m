## The command of `make simulate': driver with the arguments of the environment; an error is one line and status 1.
try
  driver (environment_options (){:});
catch err
  fprintf (stderr, "simulate: %s\n", strtrim (err.message));
  exit (1);
end_try_catch
