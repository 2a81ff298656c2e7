## -*- texinfo -*-
## @deftypefn {} {@var{arguments} =} free_rod_arguments (@var{model}, @var{gravity})
## What the generated functions of the free rod take after its state: cell arrays inertia and potential, as in their
## records.
## @end deftypefn

function arguments = free_rod_arguments (model, gravity)
  a = model.arrays;
  arguments.inertia = {a.mass_matrix, a.gyroscopic_matrix, a.coupling_vector, a.centrifugal_vector, ...
                       a.centrifugal_matrix, a.moment_of_inertia};
  arguments.potential = {a.stiffness_matrix, gravity, a.static_moment, a.first_moment_1, a.first_moment_2, ...
                         a.shortened_moment_matrix};
endfunction

%!assert (numel (free_rod_arguments (sample_mechanism ([1 2]).mechanism.models{1}, 9.81).potential), 6)
