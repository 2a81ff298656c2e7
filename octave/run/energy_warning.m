## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} energy_warning (@var{off})
## A cellstr: empty, or a warning that a run's energy balance is @var{off} by more than a thousandth, both parts of
## what changes (see @code{energy_error}).
## @end deftypefn

function warnings = energy_warning (off)
  warnings = {};
  if (off > 1e-3)
    warnings = {sprintf("the energy balance is off by %.1g of what changes: take a smaller tolerance", off)};
  endif
endfunction

%!assert (energy_warning (1e-3), {})
%!assert (energy_warning (2e-3), {"the energy balance is off by 0.002 of what changes: take a smaller tolerance"})
