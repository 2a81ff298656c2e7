## -*- texinfo -*-
## @deftypefn {} {@var{y} =} falling_step (@var{K}, @var{M}, @var{force})
## Where a @var{force} (n-by-1) moves what has the tangent @var{K} and the mass @var{M} (n-by-n) towards its
## equilibrium: Newton's own step where all is held, also by a stiffness that is not symmetric; from where it is not
## stable it falls, and what nothing holds is moved by what accelerates it by more than 1e-9 m/s^2.
## @end deftypefn

function y = falling_step (K, M, force)
  [modes, squares] = free_modes (K, M);
  least = max ([1e-13*abs(squares); 1e-12]);
  if (squares > least)
    y = K \ force;
    return;
  endif
  squares = abs (squares);
  pull = modes.'*force;
  pull(squares < least & abs (pull) < 1e-9*sqrt (norm (M))) = 0;
  y = modes*(pull./max (squares, least));
endfunction

%!assert (falling_step ([2 1; 0 4], eye (2), [3; 4]), [1; 1], 1e-14)
%!test # what is unstable falls with the force, what nothing holds stays where hardly a force moves it
%! assert (falling_step (diag ([-3 5]), eye (2), [6; 10]), [2; 2], 1e-12);
%! assert (falling_step (diag ([5 0]), eye (2), [10; 1e-10]), [2; 0], 1e-12);
