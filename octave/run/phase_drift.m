## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} phase_drift (@var{run})
## How far a point of a @var{run} (see @code{run_model}) may have run ahead or fallen behind on its way, as its energy
## balance tells (see @code{energy_error}): a speed is off by half the share that its energy is off by, and so is the
## longest way (m), from frame to frame, that one of the points goes.
## @end deftypefn

function metres = phase_drift (run)
  squares = 0;
  for name = {"x", "y", "z"}(1:2+isfield (run, "z"))
    squares += diff (run.(name{1}), 1, 2).^2;
  endfor
  metres = max ([0; sum(sqrt (squares), 2)])*max (energy_error (run.history))/2;
endfunction

%!function run = of_points (varargin)
%!  none = [0 0 0];
%!  run = struct (varargin{:});
%!  run.history = struct ("T", [2 1 0], "U", none, "Z", [0 1 2], "W", none, "D", none, "balance", [2 2 2.02], ...
%!                        "energy_floor", 0);
%!endfunction
%!test # a hundredth of the energy, 7 m to and fro
%! run = of_points ("x", [0 3 0; 0 1 0], "y", [0 4 2; 0 0 0]);
%! assert (phase_drift (run), (5 + sqrt (13))*0.005, 1e-12);
%! assert (phase_drift (setfield (run, "z", [0 0 6; 0 0 0])), (5 + 7)*0.005, 1e-12);
%! assert (phase_drift (of_points ("x", [1; 2], "y", [1; 2])), 0);
%!test # a pendulum that swings for 40 s: its drift by a loose tolerance is some times less than that
%! scene = struct ("rod", struct ("length", 0.4, "width", 0.02, "half_height", 0.005), "duration", 40);
%! scene.model.modes = [0 0];
%! scene = check_scene (scene);
%! run = @(tolerance) run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)), ...
%!                               struct ("name", "auto", "tolerance", tolerance));
%! loose = run (1e-4);
%! off = distance (loose, run (1e-8));
%! assert (off > 1e-4); assert (phase_drift (loose)/off, 4, 3);
