## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} spectrum_of_tip (@var{model}, @var{motion}, @var{step}, @var{modes}, @
##   @var{frequencies}, @var{mass})
## The amplitude spectra of the tip's deflection along and across the tangent at the start of a rod of a @var{model},
## in a @var{motion} (q, n-by-m, and phi, 1-by-m) that is sampled every @var{step} (s), as @code{tip_spectra} returns
## them, the @var{frequencies} (1-by-n, Hz) predicted.
##
## What lies beyond half the rate is not folded back: of the @var{modes} (of q, or of q and phi, normalised with the
## @var{mass}), those that are too fast are left out, and the note says so; empty where all that bends is, which has
## then only what follows slowly.  The window is Hann's; a harmonic oscillation at one of the frequencies has its
## amplitude there.
## @end deftypefn

function spectrum = spectrum_of_tip (model, motion, step, modes, frequencies, mass)
  spectrum = [];
  highest = 1/(2*step);
  if (! any (frequencies < highest & frequencies > 1e-6*max (frequencies)))
    return;
  endif
  slow = modes(:,frequencies < highest);
  spectrum = tip_spectra (deflection_of (model, motion, slow*(slow.'*mass)), step, frequencies);
endfunction

## of some modes alone, by the projector on them
function deflection = deflection_of (model, motion, projector)
  history = struct ("phi", motion.phi, "q", motion.q);
  if (rows (projector) > rows (motion.q))
    projected = projector*[motion.q; motion.phi];
    history.q = projected(1:end-1,:);
    history.phi = projected(end,:);
  else
    history.q = projector*motion.q;
  endif
  history.V = model.basis*history.q;
  history.psi = rod_tangent_angle (struct ("phi", history.phi, "V", history.q), model.arrays);
  [history.tip_x, history.tip_y] = centreline (model, model.length, history, 1);
  [along, across] = tip_deflection (history, undeformed_tip (model));
  deflection = [along; across];
endfunction

%!test # a first mode that oscillates: its frequency and amplitude, its overtones, and nothing of what is too fast
%! [scene, model] = sample_rod ([0 2]);
%! t = (0:4095)/4096;
%! motion = struct ("q", [1e-3*sin(2*pi*64*t); 1e-3*sin(2*pi*3000*t)], "phi", 0*t);
%! spectrum = spectrum_of_tip (model, motion, 1/4096, eye (2), [64 3000], eye (2));
%! [largest, k] = max (spectrum.values(2,:));
%! assert (spectrum.frequency(k), 64, 1e-9); assert (spectrum.predicted, 64);
%! [~, slope] = functions_at (model.base, 0, 1);
%! assert (largest, 1e-3*slope(1)*model.length, -1e-4);
%! away = abs (spectrum.frequency - 64) > 10 & spectrum.frequency > 10;  # the line through all is left out
%! assert (spectrum.values(2,away) < 1e-4*largest);
%! assert (spectrum.note, "sampled at 4.096 kHz; 1 predicted ones lie beyond 2.048 kHz");
%! assert (spectrum_of_tip (model, motion, 1/4096, eye (2), [2100 3000], eye (2)), []);
