## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} spin_warning (@var{scene}, @var{model}, @var{phi_dot})
## A cellstr: empty, or a warning that a @var{model} without foreshortening loses its stiffness at rates of
## rotation near @var{phi_dot} (rad/s).  Without that argument it is the rate that the scene prescribes or starts
## with, known before the run.
## @end deftypefn

function warnings = spin_warning (scene, model, phi_dot)
  if (nargin < 3)
    phi_dot = abs (scene.initial.phi_dot);
    if (! isempty (scene.rotation))
      phi_dot = fastest_rotation (scene.rotation, scene.duration);
    endif
  endif
  warnings = {};
  omega_1 = simply_supported_frequency (scene, model);
  if (strcmp (model.rung.stiffening, "none") && isempty (scene.rod.curvature) && ! strcmp (rung_name (model.rung), "rigid") && ...
      phi_dot > 0.3*omega_1)
    warnings = {sprintf(["phi_dot reaches %.3g rad/s, the simply supported rod's first frequency is %.3g rad/s:" ...
                         " without foreshortening the rod loses its stiffness there; take" ...
                         " model.stiffening = \"foreshortening\""], phi_dot, omega_1)};
  endif
endfunction

%!test # Kane's spin-up: 6 rad/s against 10.66 rad/s of the simply supported rod, and no warning with foreshortening
%! scene = check_scene (setfield (setfield (spin_up (), "model", "stiffening", "none"), "model", "modes", [0 3]));
%! warnings = spin_warning (scene, build_model (scene, rung_of_scene (scene)));
%! assert (! isempty (regexp (warnings{1}, "^phi_dot reaches 6 rad/s, .* is 10\\.7 rad/s: without foreshortening")));
%! scene.model.stiffening = "foreshortening";
%! assert (spin_warning (scene, build_model (scene, rung_of_scene (scene))), {});
