## -*- texinfo -*-
## @deftypefn {} {@var{places} =} on_picture (@var{places}, @var{scene})
## Places [x y] (m) of a picture: those of a plane as they are, those in space, [x y z], as the camera of the
## @var{scene} sees them at the start.
## @end deftypefn

function places = on_picture (places, scene)
  if (columns (places) == 3)
    [x, y] = seen (struct ("x", places(:,1), "y", places(:,2), "z", places(:,3)), scene.view);
    places = [x, y];
  endif
endfunction

%!assert (on_picture ([1 2; 3 4], struct ()), [1 2; 3 4])
%!assert (size (on_picture ([1 2 3; 4 5 6], struct ("view", struct ("elevation", 20, "azimuth", 30)))), [2 2])
