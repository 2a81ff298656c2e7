## -*- texinfo -*-
## @deftypefn {} {@var{z} =} surface_equilibrium (@var{system}, @var{z}, @var{t})
## Where the rod of @code{surface_rod} rests under the loads at the time @var{t} (default 0): coordinates (n-by-1) by
## Newton's method from @var{z} (default: the start), a step at most a tenth of the rod.  One that does not converge
## is an error.
## @end deftypefn

function z = surface_equilibrium (system, z = zeros (system.n, 1), t = 0)
  none = zeros (system.n, 1);
  smallest = Inf;
  for sweep = 1:200
    R = system.residual (t, z, none, none);
    step = -pinv (tangent_stiffness (system, t, z, none, none))*R;  # a rod without tension may turn freely
    length = system.size (step);
    z += step*min (1, 0.1*system.points(end)/length);
    if (length < 1e-12*system.points(end) || (length < 1e-8*system.points(end) && length >= smallest))
      return;
    endif
    smallest = min (smallest, length);
  endfor
  error ("toolchain:integration", "no equilibrium was found in 200 steps: the last one moved the rod by %.2g m\n", ...
         length);
endfunction

%!test # a hanging elastic line: stretched by its own weight as the strain (g - 1)/2 says
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2), "duration", 1, ...
%!                 "ends", {{"hinge", "free"}}, "rod", struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1), ...
%!                 "model", struct ("modes", [3 6]));
%! scene.initial.angle = -pi/2;
%! system = surface_rod (check_surface_scene (scene));
%! z = surface_equilibrium (system);
%! tip = system.fields (z, z, z, 1).alpha2;
%! assert (-tip - 1, 9.81/1e4/2, 1e-6);
