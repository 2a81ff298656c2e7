## -*- texinfo -*-
## @deftypefn {} {[@var{rung}, @var{why}] =} predict_rung (@var{scene})
## A guess of the smallest rung that serves a scene, and the numbers that led to it: the linear response of 30 bending
## and 30 longitudinal eigenmodes to the loads that act along the motion of the rigid rod.
##
## A kind of modes is left out from where they add up to less than half of the tolerance.  Longitudinal ones have no
## inertia where they stay as near to their static values, and foreshortening comes in where it moves the rod, or the
## first mode's phase, by as much.
## @end deftypefn

function [rung, why] = predict_rung (scene)
  share = scene.solver.tolerance/2;
  rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
  elastic = setfield (setfield (setfield (rigid, "bending", 30), "longitudinal", 30), "axial", "dynamic");
  model = build_model (scene, elastic);
  [response, phi_dot] = linear_response (scene, model, build_model (scene, rigid));
  along = 1:30;
  across = 31:rows (response.largest);

  rung = rigid;
  rung.bending = needed (response.largest(across), share);
  if (sum (response.largest(along)) > share && ! strcmp (scene.model.axial, "none"))
    rung.axial = "quasistatic";
    if (sum (response.beyond_static(along)) > share)
      rung.axial = "dynamic";
    endif
  endif
  if (! strcmp (scene.model.axial, "auto"))
    rung.axial = scene.model.axial;
  endif
  if (strcmp (rung.axial, "dynamic"))
    rung.longitudinal = max (1, needed (response.largest(along), share));
  endif

  first = response.largest(across(1));
  omega = response.omega(across(1));
  shift = first*max (abs (phi_dot))^2/omega*scene.duration/2 + (pi*first)^2/(4*scene.rod.length);
  if (strcmp (scene.model.stiffening, "foreshortening") || (shift > share && strcmp (scene.model.stiffening, "auto")))
    rung.stiffening = "foreshortening";
  endif
  why = sprintf (["loads bend the rod by %.2g m and stretch it by %.2g m, phi_dot reaches %.3g rad/s where" ...
                  " its first frequency is %.4g rad/s"], sum (response.largest(across)), ...
                 sum (response.largest(along)), max (abs (phi_dot)), omega);
endfunction

## how many of the modes before those whose largest values add up to less than the share
function n = needed (largest, share)
  n = sum (flipud (cumsum (flipud (largest))) > share);
endfunction

%!test # the paper's scene bends by half a millimetre and does not stretch
%! scene = check_scene (setfield (paper (), "solver", "tolerance", 5e-6));
%! [rung, why] = predict_rung (scene);
%! assert (rung.axial, "none");
%! assert (rung.bending >= 6 && rung.bending <= 12);  # six are needed
%! assert (rung.stiffening, "foreshortening");
%! scene.solver.tolerance = 0.1;
%! assert ({predict_rung(scene).bending, predict_rung(scene).stiffening}, {0, "none"});
%!test # one that swings slowly stretches as it would at rest
%! scene.rod = struct ("length", 1, "EA", 1e4, "EI", 100, "rhoA", 1, "half_height", 0.01);
%! [scene.duration, scene.solver.tolerance] = deal (1, 1e-4);
%! assert (predict_rung (check_scene (scene)).axial, "quasistatic");
