## -*- texinfo -*-
## @deftypefn {} {@var{forms} =} rod_forms ()
## The forms in which one rod has its equations (see @code{integrator_table}); a hub's are refused where they are none
## of momenta.
## @end deftypefn

function forms = rod_forms ()
  forms = {"rate", "oscillators", "momenta", "accelerations"};
endfunction

%!assert (numel (integrator_table (rod_forms ())), 13)
