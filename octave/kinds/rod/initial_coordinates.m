## -*- texinfo -*-
## @deftypefn {} {@var{start} =} initial_coordinates (@var{initial}, @var{model}, @var{phi_of_V})
## Initial coordinates and rates, (n+1)-by-2: [q; phi] as near to the scene's sine amplitudes V1, V2 and rates as the
## model's basis gets, in the metric of the mass matrix; phi comes on top of the scene's.
##
## @var{phi_of_V} (n-by-1) is empty for a rod that turns freely; in a hub it says how phi follows q.
## @end deftypefn

function start = initial_coordinates (initial, model, phi_of_V)
  N1 = sum (model.base.longitudinal > 0);
  N2 = sum (model.base.transversal > 0);
  most = [N1 N2];
  if (isempty (model.rung.sines))
    most = [30 30];  # eigenmodes take what they can of 30 sines
  endif
  given = [padded(initial.V1, N1, most(1), "V1"), padded(initial.V1_dot, N1, most(1), "V1_dot")
           zeros(numel (model.base.longitudinal) - N1, 2)
           padded(initial.V2, N2, most(2), "V2"), padded(initial.V2_dot, N2, most(2), "V2_dot")
           zeros(numel (model.base.transversal) - N2 + 1, 2)];
  n = columns (model.basis);
  if (! any (given(:)))
    start = zeros (n + 1, 2);
    return;
  endif
  coupling = model.whole_coupling_vector;
  mass = [model.whole_mass_matrix, coupling; coupling.', model.arrays.moment_of_inertia];
  if (isempty (phi_of_V))
    P = blkdiag (model.basis, 1);
    start = (P.'*mass*P) \ (P.'*mass*given);
  else
    P = [model.basis; phi_of_V.'];
    start = [(P.'*mass*P) \ (P.'*mass*given); 0 0];
  endif
endfunction

function amplitudes = padded (given, n, most, name)
  if (numel (given) > most && any (given(most+1:end)))
    scene_error ("initial.%s has %d amplitudes: the model has %d such modes", name, numel (given), most);
  endif
  amplitudes = [given(1:min (n, end))(:); zeros(n - numel (given), 1)];
endfunction

%!error <initial.V2 has 8 amplitudes: the model has 7 such modes>
%! scene = check_scene (setfield (setfield (paper (), "initial", "V2", ones (1, 8)), "model", "modes", [7 7]));
%! hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%!test # sines take them as they are
%! scene = check_scene (setfield (setfield (paper (), "initial", "V2", [1 2]), "model", "modes", [1 3]));
%! start = hinged_rod (scene, build_model (scene, rung_of_scene (scene))).initial_state;
%! assert (start(1:5), [0; 1; 2; 0; -pi/6], 1e-12);
%!error <initial.V1 has 31 amplitudes: the model has 30 such modes>
%! scene = check_scene (setfield (paper (), "initial", "V1", ones (1, 31)));
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 1, "axial", "dynamic", "stiffening", "none");
%! initial_coordinates (scene.initial, build_model (scene, rung), []);
%!error <initial.V2 has 31 amplitudes: the model has 30 such modes>
%! scene = check_scene (setfield (paper (), "initial", "V2", ones (1, 31)));
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 1, "axial", "dynamic", "stiffening", "none");
%! initial_coordinates (scene.initial, build_model (scene, rung), []);
