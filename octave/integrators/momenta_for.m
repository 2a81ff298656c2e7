## -*- texinfo -*-
## @deftypefn {} {@var{momenta} =} momenta_for (@var{method}, @var{system})
## The form in coordinates and momenta of a @var{system}, for a @var{method} that needs it.
## @end deftypefn

function momenta = momenta_for (method, system)
  if (! isfield (system, "momenta"))
    scene_error ("solver.name is \"%s\", which takes no prescribed rotation: take generalized_alpha or waveform", ...
                 method);
  endif
  momenta = system.momenta;
endfunction

%!error <solver.name is "trigonometric", which takes no prescribed rotation> momenta_for ("trigonometric", struct ())
%!assert (momenta_for ("trigonometric", struct ("momenta", 3)), 3)
