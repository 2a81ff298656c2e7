## -*- texinfo -*-
## @deftypefn {} {@var{found} =} at_rest (@var{kind}, @var{scene}, @var{t}, @var{measure}, @var{enough})
## The equilibrium of a checked scene of a @var{kind} (see @code{kind_of}) under its loads at the time @var{t} (s),
## with the modes that it states, or with 4, 8, 16 and 32 base functions of each sort until none of @var{measure}
## (found), a row of numbers, changes by more than @var{enough} of itself, 1e-6 by default, or a thousandth of that of
## the largest; or as many of them as find an equilibrium with a positive mass.
##
## @var{found} is a struct of balance (see @code{mechanism_at_rest}), q, lambda and linear (see @code{equilibrium}),
## vibrations (see @code{vibrations}), functions (how many of each sort, NaN: stated) and change, of each number by the
## last doubling (NaN: stated, Inf: it has no one before).
## @end deftypefn

function found = at_rest (kind, scene, t, measure, enough = 1e-6)
  if (isempty (kind.at_rest))
    scene_error ("the kind \"%s\" says nothing of its equilibrium", kind.name);
  endif
  rung = kind.stated (scene);
  if (! isempty (rung))
    found = equilibrium_of (kind, scene, kind.build (scene, rung), t, []);
    found.functions = NaN;
    found.change = NaN (size (measure (found)));
    warn_of_strains (found);
    return;
  endif
  last = [];
  coarse = [];
  for n = [4 8 16 32]
    show_progress (sprintf ("equilibrium with %d base functions of each sort", n));
    try
      coarse = equilibrium_of (kind, scene, kind.sized (scene, n), t, coarse);
    catch err
      rethrow_others (err, "toolchain:scene:equilibrium", "toolchain:scene:mass");
      if (isempty (coarse))
        rethrow (err);
      elseif (isinf (found.change))  # the first that was found: half as many stand before it
        found.change = change_from_half (kind, scene, t, measure, found, err);
      endif
      break;  # the change that the last doubling made stays the one that is said
    end_try_catch
    found = coarse;
    found.functions = n;
    [found.change, last] = relative_change (measure (found), last);
    if (n >= found.balance.most || found.change <= enough)
      break;
    endif
  endfor
  show_progress ("");
  warn_of_strains (found);
endfunction

## where there are models of half as many functions; else the error stays that more of them had
function change = change_from_half (kind, scene, t, measure, found, err)
  half = kind.sized (scene, found.functions/2);
  if (isempty (half))
    rethrow (err);
  endif
  change = relative_change (measure (found), measure (equilibrium_of (kind, scene, half, t, found)));
endfunction

## what models of the second order drop is of the order of the slope's square
function warn_of_strains (found)
  [slope, strain] = deal (0);
  if (isfield (found.balance, "steepest"))
    [slope, strain] = found.balance.steepest (found.q);
  endif
  if (strain > 0.01)
    say (["warning: rods have strains up to %.2g there, linear elasticity holds for small ones: take smaller loads, a" ...
          " larger EA, or rods that reach from joint to joint"], strain);
  endif
  if (slope > 0.1)
    say (["warning: rods bend by slopes up to %.2g there, and what they drop is some %.0f %% of how they bend and" ...
          " vibrate: EXACT=yes takes geometrically exact ones"], slope, 100*slope^2);
  endif
endfunction

function found = equilibrium_of (kind, scene, model, t, coarse)
  found.time = t;
  found.balance = balance_near (kind, scene, model, coarse);
  [found.q, found.lambda, found.linear] = equilibrium (found.balance, t);
  refuse_negative_mass (found.linear, sprintf ("at t = %g s", t));
  found.vibrations = vibrations (found.linear);
endfunction

%!function scene = held (varargin)   # a rod of unit length, mass and EI
%!  scene.rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1, "half_height", 0.005);
%!  scene.model = struct ("modes", "auto", "energy", "uniaxial", "rotary_inertia", false);
%!  [scene.gravity, scene.duration, scene.joints] = deal (0, 1, varargin);
%!  scene = scene_at_rest (scene);
%!endfunction
%!function omega = slowest (scene, n)
%!  scene = check_mechanism (scene);
%!  omega = at_rest (mechanism_kind (), scene, 0, @(found) found.vibrations.omega(1:n)).vibrations.omega(1:n);
%!endfunction
%!test # a hinge with a spring of EI/l: its characteristic equation's roots (Hodges and Pierce 2011, Table 3.10)
%! spring = struct ("kind", "torsion_spring", "stations", 0, "stiffness", 1);
%! assert (slowest (held (spring), 2), [1.55729786 16.2500852], -1e-6);
%!test # clamped and free, clamped and hinged, clamped at both ends, free at a hinge (Blevins 1979)
%! clamp = struct ("kind", "angle", "stations", 0, "value", 0);
%! assert (slowest (held (clamp), 3), [1.87510407 4.69409113 7.85475744].^2, -1e-6);
%! hinge = struct ("kind", "slider", "stations", 1, "point", [0 0], "direction", 0);
%! assert (slowest (held (clamp, hinge), 2), [3.92660231 7.06858275].^2, -1e-6);
%! weld = struct ("kind", "angle", "stations", 1, "value", 0);
%! assert (slowest (held (clamp, hinge, weld), 2), [4.73004074 7.85320462].^2, -1e-6);
%! assert (slowest (held (), 3), [0, 3.92660231^2, 7.06858275^2], 1e-4);
%!function said = bent (force)   # a cantilever of unit length and EI
%!  clamp = struct ("kind", "angle", "stations", 0, "value", 0);
%!  scene = check_mechanism (held (clamp, struct ("kind", "force", "stations", 1, "value", [0 force])));
%!  said = evalc ("at_rest (mechanism_kind (), scene, 0, @(found) found.vibrations.omega(1));");
%!endfunction
%!test # what bends much has a warning
%! assert (isempty (strfind (bent (0.1), "warning")));
%! said = "warning: rods bend by slopes up to 0.29 there, and what they drop is some 8 %";
%! assert (strncmp (bent (1), said, numel (said)));
%!test # and so has what is stretched: by a force of EA/40
%! scene = held (struct ("kind", "weld", "bodies", 1, "stations", 0), ...
%!               struct ("kind", "force", "bodies", 1, "stations", 1, "value", [1e6/40, 0]));
%! said = evalc ("at_rest (mechanism_kind (), check_mechanism (scene), 0, @(found) found.vibrations.omega(1));");
%! assert (strncmp (said, "warning: rods have strains up to 0.025 there", 44));
%!test # stated modes are taken as they are
%! scene = setfield (held (), "bodies", {setfield(held ().bodies{1}, "model", "modes", [1 2])});
%! found = at_rest (mechanism_kind (), check_mechanism (scene), 0, @(found) found.vibrations.omega);
%! assert (found.functions, NaN); assert (found.change, NaN (1, 4));
%!test # beside a rod of near to infinite stiffness a soft one has its frequencies: clamped, with a mass at its tip
%! rod = @(EI, l) struct ("length", l, "EA", 1e7, "EI", EI, "rhoA", 0.7, "rhoI", 0);
%! scene = held (struct ("kind", "angle", "stations", 0, "value", 0));
%! model = struct ("modes", "auto", "stiffening", "exact");
%! scene.bodies = {struct("rod", rod (1e12, 0.6), "model", model), ...
%!                 struct("rod", rod (20, 1.3), "model", model, "tip_mass", 0.4)};
%! scene.joints = [scene.joints, {struct("kind", "weld", "bodies", [1 2], "stations", [0.6 0])}];
%! assert (slowest (scene, 2), [6.65468 53.9464], -5e-6);
%!test # a rod that a hinge without weight holds in its middle turns: that is no vibration, and it does not grow
%! scene = held ();
%! scene.joints{1} = struct ("kind", "revolute", "bodies", 1, "stations", 0.5, "point", [0.5 0]);
%! scene = check_mechanism (scene);
%! modes = at_rest (mechanism_kind (), scene, 0, @(found) found.vibrations.omega(1:2)).vibrations;
%! assert ([modes.omega(1), modes.rate], zeros (1, 1 + numel (modes.rate)));
%! assert (modes.omega(2), (1.87510407/0.5)^2, -1e-4);
%!error <the kind "string" says nothing of its equilibrium>
%! at_rest (struct ("name", "string", "at_rest", []), struct (), 0, @(found) 1);
