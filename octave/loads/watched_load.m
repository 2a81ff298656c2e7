## -*- texinfo -*-
## @deftypefn {} {@var{watched} =} watched_load (@var{name}, @var{load})
## The function @var{load} of t (s) with an eye on it: where it fails in the run, or is not finite, the integration
## stops with an error that says the load's @var{name} and the time.  The check of the scene (see @code{load_breaks})
## finds most of that before the work; what is empty or a number comes back as it is.
## @end deftypefn

function watched = watched_load (name, load)
  watched = load;
  if (is_function_handle (load))
    watched = @(t) value_at (name, load, t);
  endif
endfunction

function value = value_at (name, load, t)
  try
    value = load (t);
  catch err
    stop (sprintf ("%s fails at t = %.9g: %s", name, t(1), placed_message (err)));
  end_try_catch
  if (! all (isfinite (value(:))))
    bad = any (! isfinite (reshape (value, [], numel (t))), 1);
    stop (sprintf ("%s gives a number that is not finite at t = %.9g", name, t(find (bad, 1))));
  endif
endfunction

function stop (what)
  error ("toolchain:integration", "%s, which the check of the scene did not see: mend that load\n", what);
endfunction

%!assert (watched_load ("force", []), [])
%!assert (watched_load ("force", @(t) [t t]) (2), [2 2])
%!error <moment gives a number that is not finite at t = 0.6, which>
%! watched_load ("moment", @(t) 1./(t != 0.6)) ([0.5 0.6 0.7])
%!error <force fails at t = 0.5: no wind> watched_load ("force", @(t) error ("no wind")) (0.5)
%!function check_line (folder, scratch)
%!  write_text (fullfile (folder, "windy.m"), "function y = windy (t)\n  y = [1 2](t);\nend\n");
%!  before = addpath (folder);
%!  unwind_protect
%!    fail ("watched_load ('force', @windy) (3)", "^force fails at t = 3: windy.m, line 2: .*out of bound.*, which");
%!    fail ("watched_load ('force', @(t) windy (t)) (3)", "^force fails at t = 3: windy.m, line 2: ");
%!  unwind_protect_cleanup
%!    path (before);
%!  end_unwind_protect
%!endfunction
%!test # with the line, where it is the interpreter's error
%! in_scratch (@check_line);
%!test
%! try
%!   watched_load ("force", @(t) [NaN 1]) (0.5);
%! catch err
%!   assert (err.identifier, "toolchain:integration");
%! end_try_catch
