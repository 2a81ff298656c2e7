## -*- texinfo -*-
## @deftypefn {} {@var{mass} =} mass_with_rotation (@var{arrays})
## The mass matrix of a rod's coordinates V and its rotation phi together, (N+1)-by-(N+1), where it is not deformed:
## V_dot.' mass_matrix V_dot + 2 phi_dot coupling_vector.' V_dot + moment_of_inertia phi_dot^2 is twice the kinetic
## energy (@var{arrays} as of @code{rod_arrays}).
## @end deftypefn

function mass = mass_with_rotation (arrays)
  mass = [arrays.mass_matrix, arrays.coupling_vector; arrays.coupling_vector.', arrays.moment_of_inertia];
endfunction

%!test # a half wave of 2 m with 3 kg/m that turns
%! arrays = rod_arrays (base_functions ([], 1, 2), struct ("rhoA", 3, "rhoI", 0, "EA", 5, "EI", 7, "GI", 0), 0);
%! assert (mass_with_rotation (arrays), 3*[2/2, 2^2/pi; 2^2/pi, 2^3/3], 1e-12);
