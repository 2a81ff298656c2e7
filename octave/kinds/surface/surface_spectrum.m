## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} surface_spectrum (@var{scene}, @var{run})
## The spectra of the tip (see @code{tip_spectra}) of a rod on a surface, from the tangent at its start and across that
## in the tangent plane, of the states between the frames of a @var{run} (see @code{run_model}), without predicted
## frequencies: they change with its place.  Empty without such states.
## @end deftypefn

function spectrum = surface_spectrum (scene, run)
  spectrum = [];
  if (! isfield (run, "between"))
    return;
  endif
  [t, system] = deal (run.between.t, run.model);
  z = run.between.states(1:system.n,:);
  start = system.fields (t, z, z, z, 0);
  tip = system.fields (t, z, z, z, scene.rod.length);
  [from{1:3}] = system.surface.position (start);
  [to{1:3}] = system.surface.position (tip);
  [tangent{1:3}] = system.surface.tangent (start);
  [normal{1:3}] = system.surface.normal (start);
  way = vertcat (to{:}) - vertcat (from{:});
  along = vertcat (tangent{:});
  along ./= norm (along, "columns");
  across = cross (vertcat (normal{:}), along);
  spectrum = tip_spectra ([dot(way, along); dot(way, across)], diff (t)(1));
endfunction

%!test # a clamped rod that was bent rings at its first frequency, with the amplitude of its bend
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "ends", {{"clamped", "free"}}, ...
%!                 "rod", struct ("length", 1, "EA", 1e5, "EI", 1, "rhoA", 1), "duration", 10, "gravity", 0, ...
%!                 "model", struct ("modes", [6 6]), "frames_per_second", 10, "solver", struct ("tolerance", 1e-5));
%! scene.initial.shape = @(xi) [xi; 1e-3*(6*xi.^2 - 4*xi.^3 + xi.^4)/3];
%! scene = check_surface_scene (scene);
%! run = run_model (surface_kind (), scene, surface_rod (scene));
%! spectrum = surface_spectrum (scene, run);
%! [largest, k] = max (spectrum.values(2,:));
%! assert (spectrum.frequency(k), 1.87510407^2/(2*pi), 0.05); assert (largest, 1e-3, 1.5e-4);
%! assert (surface_spectrum (scene, rmfield (run, "between")), []);
