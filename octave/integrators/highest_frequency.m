## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} highest_frequency (@var{system})
## The highest frequency (rad/s) of the linear oscillation of a system (see @code{hinged_rod}).
## @end deftypefn

function omega = highest_frequency (system)
  omega = sqrt (max ([0; real(eig (full (system.stiffness), full (system.mass)))]));
endfunction

%!assert (highest_frequency (struct ("stiffness", diag ([9 50]), "mass", diag ([1 2]))), 5, 1e-12)
