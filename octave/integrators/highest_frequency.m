## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} highest_frequency (@var{system})
## The highest frequency (rad/s) of the linear oscillation of a system (see @code{hinged_rod}).
## @end deftypefn

function omega = highest_frequency (system)
  [~, squares] = free_modes (system.stiffness, system.mass);
  omega = sqrt (max ([0; squares]));
endfunction

%!assert (highest_frequency (struct ("stiffness", diag ([9 50]), "mass", diag ([1 2]))), 5, 1e-12)
