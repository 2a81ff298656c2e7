## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} without_probed (@var{scene})
## A @var{scene} without what its check has noted of its loads (see @code{load_breaks}), so that it can be checked
## anew.
## @end deftypefn

function scene = without_probed (scene)
  if (isfield (scene, "probed"))
    scene = rmfield (scene, "probed");
  endif
endfunction

%!assert (without_probed (struct ("duration", 1, "probed", 2)), struct ("duration", 1))
