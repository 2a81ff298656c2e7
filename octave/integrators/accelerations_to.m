## -*- texinfo -*-
## @deftypefn {} {@var{a} =} accelerations_to (@var{method}, @var{h}, @var{z}, @var{z_dot}, @var{places})
## Accelerations (n-by-s) at the stages of a step of @var{h} (s) of a collocation @var{method} from the place @var{z}
## and the velocity @var{z_dot} on, that bring the stages to @var{places} (n-by-s).
## @end deftypefn

function a = accelerations_to (method, h, z, z_dot, places)
  a = (places - z - h*z_dot*method.points.')/h^2/method.AA.';
endfunction

%!test # of a parabola they are what it has
%! method = collocation (3);
%! [z, v, a] = deal ([1; 2], [0.5; -1], [3; -4]);
%! at = 0.1*method.points.';
%! assert (accelerations_to (method, 0.1, z, v, z + v.*at + a.*at.^2/2), a*ones (1, 3), 1e-11);
