## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} try_rung (@var{ladder}, @var{rung}, @var{like})
## Run a @var{rung} of a @var{ladder} of models (see @code{choose}): what its function trial returns, a struct with the
## points x and y, and z on a surface (points-by-frames, m), and the integrator's count, and with the rung and the
## seconds that it took.  The trial of a @var{like} rung, where there is one, leads it.  A run that fails leaves error
## and identifier, its message and what sort it is of, "" for others, and NaN for the points.
## @end deftypefn

function trial = try_rung (ladder, rung, like = [])
  start = tic ();
  show_progress (["trying " ladder.name(rung)]);
  try
    trial = ladder.trial (rung, like);
    [trial.error, trial.identifier] = deal ("");
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    trial = struct ("x", NaN, "y", NaN, "error", strtrim (err.message), "identifier", err.identifier);
    trial.count = struct ("method", "auto", "steps", 0, "calls", 0, "seconds", NaN);
  end_try_catch
  trial.rung = rung;
  trial.seconds = toc (start);
endfunction

%!test # what fails is no end, but for a mistake in the program
%! ladder = struct ("name", @(n) "two modes", "trial", @(n, like) error ("toolchain:integration", "it shrank\n"));
%! trial = try_rung (ladder, 2);
%! assert (trial.error, "it shrank"); assert (trial.rung, 2);
%! assert (distance (trial, struct ("x", 1, "y", 2)), Inf);
%!error <nonconformant> try_rung (struct ("name", @(n) "", "trial", @(n, like) [1 2] + [1 2 3]), 2);
%!test # what runs has no error
%! trial = try_rung (struct ("name", @(n) "", "trial", @(n, like) struct ("x", n, "y", 0)), 2);
%! assert (trial.x, 2); assert (trial.error, ""); assert (trial.seconds >= 0);
