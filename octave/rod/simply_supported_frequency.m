## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} simply_supported_frequency (@var{scene}, @var{model})
## The first frequency (rad/s) of the scene's rod with both ends hinged, from the coefficients of the first sine (3).
## @end deftypefn

function omega = simply_supported_frequency (scene, model)
  section = model.section;
  length = scene.rod.length;
  omega = sqrt (rod_stiffness_transversal (1, 1, length, section.EI) ...
                /rod_mass_transversal (1, 1, length, section.rhoA, section.rhoI));
endfunction

%!test
%! scene = check_scene (spin_up ());
%! model = struct ("section", struct ("rhoA", 1.2, "rhoI", 0, "EI", 1.4e4));
%! assert (simply_supported_frequency (scene, model), pi^2/100*sqrt (1.4e4/1.2), 1e-12);
