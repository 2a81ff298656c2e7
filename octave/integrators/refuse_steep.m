## -*- texinfo -*-
## @deftypefn {} {} refuse_steep (@var{system}, @var{solver}, @var{t}, @var{y})
## An error where rods of a @var{system} have a slope above @var{solver}.steepest in the state @var{y} at the time
## @var{t} (s): system.steepest (y), which exact rods do not have.  Where @var{solver} has no such field all goes on.
## @end deftypefn

function refuse_steep (system, solver, t, y)
  if (! (isfield (solver, "steepest") && isfield (system, "steepest")))
    return;
  endif
  slope = system.steepest (y);
  if (slope > solver.steepest)
    error ("toolchain:integration:steep", ["at t = %.4g s of %g s a slope reaches %.2g, far beyond what models of" ...
           " small slopes hold for; take a stiffer rod or smaller loads\n"], t, system.duration, slope);
  endif
endfunction

%!error <at t = 0.5 s of 2 s a slope reaches 3, far beyond .*; take a stiffer rod>
%! refuse_steep (struct ("steepest", @(y) max (y), "duration", 2), struct ("steepest", 1.5), 0.5, [1; 3]);
%!test
%! system = struct ("steepest", @(y) y, "duration", 2);
%! refuse_steep (system, struct ("steepest", 1.5), 0, 1); refuse_steep (system, struct ("tolerance", 1), 0, 3);
%! refuse_steep (struct ("duration", 2), struct ("steepest", 1.5), 0, 3);
