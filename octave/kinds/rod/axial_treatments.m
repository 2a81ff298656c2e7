## -*- texinfo -*-
## @deftypefn {} {@var{names} =} axial_treatments (@var{scene})
## How longitudinal modes may be taken in a @var{scene}, the simplest first (see @code{rung_of_scene}): springs pull
## modes without inertia by forces that depend on where these are, which their equations have not.
## @end deftypefn

function names = axial_treatments (scene)
  names = {"none", "quasistatic", "dynamic"};
  if (! isempty (scene.joints))
    names = {"none", "dynamic"};
  endif
endfunction

%!assert (numel (axial_treatments (struct ("joints", []))), 3)
%!assert (axial_treatments (struct ("joints", struct ("kind", "spring"))), {"none", "dynamic"})
