## -*- texinfo -*-
## @deftypefn {} {[@var{history}, @var{count}] =} run_surface (@var{system}, @var{scene}, @var{balance})
## The motion of the rod of @code{surface_rod} at the frame times (see @code{measure_surface}), by the scene's solver,
## and the count of @code{integrate}.  The energy balance is kept to @var{balance} a frame (default 3e-9), the place to
## an equal part of the scene's tolerance.  A rod that touches itself and an energy balance that is lost are errors.
## @end deftypefn

function [history, count] = run_surface (system, scene, balance = 3e-9)
  times = frame_times (scene);
  if (any (strcmp (scene.solver.name, {"auto", "gauss"})))
    [states, count] = integrate_gauss (system, times, scene.solver.tolerance/numel (times), balance);
  else
    [states, count] = integrate (system, times, scene.solver);
  endif
  history = measure_surface (system, scene, times, states);
  watch_balance (history, system, count);
  refuse_self_contact (history, scene);
endfunction

%!test # two ways through time
%! scene = check_surface_scene (setfield (setfield (large_swing (), "duration", 0.1), "model", "modes", [4 4]));
%! system = surface_rod (scene);
%! by = @(name, tolerance) setfield (scene, "solver", struct ("name", name, "tolerance", tolerance));
%! tip = @(name, tolerance) run_surface (system, by (name, tolerance)).tip(:,end);
%! assert (tip ("auto", 1e-9), tip ("lsode_bdf", 1e-7), 1e-6);
