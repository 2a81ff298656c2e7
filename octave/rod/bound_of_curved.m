## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} bound_of_curved (@var{model}, @var{V}, @var{duration})
## How far points of a curved rod may be off because its strains are linear in its displacements: the slope times the
## deformation of a motion of amplitudes @var{V} (N-by-m), and a quarter of that for each radian of the phase through
## which the slowest mode of the @var{model} goes in the @var{duration} (s).  Of arcs drawn at random it is 1 to 6 times
## how far they are off the geometrically exact rod, of the scene hook 20 times.
## @end deftypefn

function metres = bound_of_curved (model, V, duration)
  metres = 0;
  squares = diag (model.arrays.stiffness_matrix)./diag (model.arrays.mass_matrix);
  if (! isempty (squares))
    of = @(V) struct ("phi", zeros (1, columns (V)), "V", V);
    [x, y] = centreline (model, linspace (0, model.length, 21), of (V), 1);
    [x_0, y_0] = centreline (model, linspace (0, model.length, 21), of (0*V), 1);
    metres = largest_slopes (model)(V)*max (hypot (x - x_0, y - y_0)(:))*(1 + sqrt (min (squares))*duration/4);
  endif
endfunction

%!test # as the square of the amplitudes, more in a longer run, nothing of a rigid rod
%! scene = check_scene (arc_pendulum ());
%! model = build_curved_model (scene, curved_rung ([1 2]));
%! bound = @(factor, duration) bound_of_curved (model, factor*[1e-5 2e-5; 1e-3 2e-3; 0 1e-3], duration);
%! assert (bound (3, 1), 9*bound (1, 1), 1e-12*bound (1, 1));
%! omega = sqrt (min (diag (model.arrays.stiffness_matrix)./diag (model.arrays.mass_matrix)));
%! assert (bound (1, 8/omega), 3*bound (1, 0), 1e-12);
%! assert (bound (1, 0) > 0); assert (bound_of_curved (build_curved_model (scene, curved_rung ([0 0])), zeros (0, 2), 1), 0);
