## -*- texinfo -*-
## @deftypefn {} {@var{place} =} place_rod (@var{scene}, @var{surface})
## Where the rod of a checked scene starts, and how it may move from there: a struct of start and velocity (N-by-1, the
## coefficients q of the chart's coordinates in their base functions and their rates), and basis (N-by-n,
## orthonormal directions that the ends leave free).
## @end deftypefn

function place = place_rod (scene, surface)
  l = scene.rod.length;
  [x, weights] = gauss_rule (quadrature_points (scene.model));
  xi = l*x;
  x = x.';
  weights = weights.';
  stations = [0, xi, l];
  if (isempty (scene.initial.shape))
    alpha = laid_rod (surface, scene.rod, scene.initial.point, scene.initial.angle, stations);
  else
    alpha = values_of (scene.initial.shape, "initial.shape", numel (stations), stations);
  endif
  q = projected (alpha(:,2:end-1), x, weights, scene.model);
  if (! any (strcmp (scene.ends, "hinge")) && ! any (strcmp (scene.ends, "clamped")))
    Phi = zeros (0, numel (q));
  else
    [~, slopes_1] = rod_functions (scene.model, 1, [0; l], l);
    [~, slopes_2] = rod_functions (scene.model, 2, [0; l], l);
    n = columns (slopes_1);
    slope = [slopes_1*q(1:n), slopes_2*q(n+1:end)].';
    Phi = surface_constraints (scene.ends, scene.model, l, slope);
  endif
  place.start = q;
  place.basis = null (Phi);
  if (isempty (Phi))
    place.basis = full (eye (numel (q)));
  endif
  place.velocity = zeros (size (q));
  if (! isempty (scene.initial.velocity))
    velocity = projected (values_of (scene.initial.velocity, "initial.velocity", numel (xi), xi, alpha(:,2:end-1)), ...
                          x, weights, scene.model);
    place.velocity = place.basis*(place.basis.'*velocity);
  endif
endfunction

function q = projected (alpha, x, weights, model)
  q = [];
  for i = 1:2
    base = sqrt (weights).*rod_functions (model, i, x, 1);
    if (cond (base) > 1e5)
      scene_error (["the first %d sines are all but polynomials of %d terms (condition number %.2g): take fewer" ...
                    " model.modes, 4 say, beside model.sines"], model.sines(i), model.modes(i), cond (base));
    endif
    q = [q; base \ (sqrt (weights).*alpha(i,:).')];
  endfor
endfunction

function alpha = values_of (f, name, m, varargin)
  try
    alpha = f (varargin{:});
  catch err
    scene_error ("%s fails: %s", name, placed_message (err));
  end_try_catch
  if (! (isnumeric (alpha) && isreal (alpha) && isequal (size (alpha), [2, m]) && all (isfinite (alpha(:)))))
    scene_error ("%s gives a %s %s: it takes a finite number for each coordinate and xi, 2-by-%d", name, ...
                 mat2str (size (alpha)), class (alpha), m);
  endif
endfunction

%!test # a hinge leaves the other coefficients free, and a straight rod is straight
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 1), "ends", {{"hinge", "free"}}, ...
%!                 "model", struct ("modes", [3 4]), "initial", struct ("point", [1 2], "angle", pi/2));
%! scene = check_surface_scene (scene);
%! place = place_rod (scene, surface_functions (rmfield (scene.surface, "side")));
%! assert (place.start, [1 0 0 3 1 0 0].', 1e-12);
%! assert (size (place.basis), [7 5]);
%!error <the first 9 sines are all but polynomials of 20 terms>
%! scene = setfield (setfield (large_swing (), "model", "modes", [20 20]), "model", "sines", [9 9]);
%! driver (scene, "output", "");
